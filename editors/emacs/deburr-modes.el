;;; deburr-modes.el --- Modes for programs of CNC machines -*- lexical-binding: t -*-
;; Written by `python -m deburr.dev.generate`.

;;; Code:

(define-derived-mode deburr-metagcode-mode prog-mode "MetaGCODE"
  "Major mode for MetaGCODE programs."
  (setq-local comment-start "; " comment-end ""))
(put 'deburr-metagcode-mode 'eglot-language-id "metagcode")
(add-to-list 'auto-mode-alist '("\\.\\(?:mgc\\)\\'" . deburr-metagcode-mode))

(define-derived-mode deburr-rs274-mode prog-mode "RS274/NGC"
  "Major mode for RS274/NGC programs."
  (setq-local comment-start "; " comment-end ""))
(put 'deburr-rs274-mode 'eglot-language-id "rs274")
(add-to-list 'auto-mode-alist '("\\.\\(?:ngc\\)\\'" . deburr-rs274-mode))

(define-derived-mode deburr-cgt-mode prog-mode "SmartCAM CGT"
  "Major mode for SmartCAM CGT programs."
  (setq-local comment-start "// " comment-end ""))
(put 'deburr-cgt-mode 'eglot-language-id "cgt")
(add-to-list 'auto-mode-alist '("\\.\\(?:cgt\\)\\'" . deburr-cgt-mode))

(define-derived-mode deburr-z32-mode prog-mode "D.Electron Z32"
  "Major mode for D.Electron Z32 programs."
  (setq-local comment-start "; " comment-end ""))
(put 'deburr-z32-mode 'eglot-language-id "z32")
(add-to-list 'auto-mode-alist '("\\.\\(?:z32\\)\\'" . deburr-z32-mode))

(define-derived-mode deburr-gcode-mode prog-mode "G-code"
  "Major mode for G-code programs."
  (setq-local comment-start "; " comment-end ""))
(put 'deburr-gcode-mode 'eglot-language-id "gcode")
(add-to-list 'auto-mode-alist '("\\.\\(?:nc\\|tap\\|cnc\\|gcode\\)\\'" . deburr-gcode-mode))

(defconst deburr-modes
  '(deburr-metagcode-mode
    deburr-rs274-mode
    deburr-cgt-mode
    deburr-z32-mode
    deburr-gcode-mode)
  "The modes in which the server is of use.")

(provide 'deburr-modes)
;;; deburr-modes.el ends here
