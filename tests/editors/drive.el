;;; drive.el --- What a user does in Emacs with one program, and what is seen of it -*- lexical-binding: t -*-
;; PLAN: a file with what to do; FACTS: where to write it down. Standard input answers what Emacs asks.

(defvar drive-plan (with-temp-buffer
                     (insert-file-contents (getenv "PLAN"))
                     (json-parse-buffer)))

(defun drive-get (&rest keys)
  (seq-reduce (lambda (table key) (gethash key table)) keys drive-plan))

(defun drive-say (what value)
  (let ((line (concat (json-serialize (vector what value)) "\n")))
    (write-region line nil (getenv "FACTS") 'append 'quiet)))

(defun drive-wait (what test)
  (with-timeout (30 (drive-say "waited in vain" what) (kill-emacs 1))
    (while (not (funcall test)) (accept-process-output nil 0.02))))

(defun drive-place (text)
  (goto-char (point-min))
  (let ((case-fold-search nil)) (search-forward text))
  (goto-char (match-beginning 0)))

(defun drive-line () (buffer-substring-no-properties (line-beginning-position) (line-end-position)))
(defun drive-lines () (vconcat (split-string (buffer-substring-no-properties (point-min) (point-max)) "\n" t)))
(defun drive-here () (format "%s:%d" (file-name-nondirectory buffer-file-name) (line-number-at-pos)))

(defun drive-errors ()
  (flymake-start)
  (vconcat
   (delq nil
         (mapcar (lambda (each)
                   (when (eq (flymake-diagnostic-type each) 'eglot-error)
                     (save-excursion
                       (goto-char (flymake-diagnostic-beg each))
                       (format "%d:%d %s" (line-number-at-pos) (1+ (current-column)) (flymake-diagnostic-text each)))))
                 (flymake-diagnostics)))))

(defun drive ()
  (setq eglot-confirm-server-initiated-edits nil make-backup-files nil)
  (find-file (drive-get "main"))
  (run-hooks 'post-command-hook)                 ; where `eglot-ensure' waits; there is no command in a batch
  (drive-wait "the server" #'eglot-managed-p)
  (drive-say "filetype" (symbol-name major-mode))
  (drive-say "commentstring" comment-start)
  (drive-wait "diagnostics" (lambda () (> (length (drive-errors)) 0)))
  (drive-say "errors" (drive-errors))

  (setq last-nonmenu-event ?x)                   ; Eglot asks in a menu if a command did not come from the keyboard
  (drive-place (drive-get "fault"))
  (call-interactively #'eglot-code-actions)
  (drive-say "mended" (drive-line))
  (save-buffer)                                  ; sends the change too; else it waits for an idle moment
  (drive-wait "no diagnostics" (lambda () (= (length (drive-errors)) 0)))

  (drive-place (drive-get "hover"))
  (let (said)
    (eglot-hover-eldoc-function (lambda (text &rest _) (when text (setq said text))))
    (drive-wait "hover" (lambda () said))
    (drive-say "hover" (substring-no-properties said)))

  (let ((main (current-buffer)))
    (drive-place (drive-get "definition"))
    (call-interactively #'xref-find-definitions)
    (drive-say "definition" (drive-here))
    (switch-to-buffer main)

    (drive-place (aref (drive-get "rename") 0))
    (eglot-rename (aref (drive-get "rename") 1))
    (let ((texts (make-hash-table :test #'equal)))
      (dolist (buffer (buffer-list))
        (with-current-buffer buffer
          (when (and buffer-file-name (buffer-modified-p))
            (puthash (file-name-nondirectory buffer-file-name) (drive-lines) texts))))
      (drive-say "renamed" texts))
    (save-some-buffers t)

    (drive-place (drive-get "expand" "from"))
    (deburr-expand (drive-get "expand" "define"))
    (drive-say "flat" (drive-lines))
    (drive-say "flat line" (line-number-at-pos))
    (goto-char (point-min))
    (forward-line (1- (drive-get "expand" "line")))
    (call-interactively (key-binding (kbd "RET")))
    (drive-say "source" (drive-here)))
  (kill-emacs 0))

(drive)
;;; drive.el ends here
