;;; deburr.el --- Eglot for programs of CNC machines -*- lexical-binding: t -*-

;;; Commentary:
;; Tells Eglot of the server, and shows expanded programs: `deburr-expand'.

;;; Code:

(require 'eglot)
(require 'deburr-modes)

(defgroup deburr nil "Programs of CNC machines." :group 'languages)

(defcustom deburr-command '("deburr" "server")
  "How the server is started; to be set before this file is loaded."
  :type '(repeat string))

;; Each mode has a server of its own: older versions of Eglot tell a server that looks after several modes
;; the language of the first for all of them.
(dolist (mode deburr-modes)
  (add-to-list 'eglot-server-programs (cons mode deburr-command)))

(defvar-local deburr--source nil "The buffer that this one is the expanded program of.")
(defvar-local deburr--define nil "The values that variables were given, as a property list.")

(defvar deburr-expanded-mode-map
  (let ((map (make-sparse-keymap)))
    (define-key map (kbd "RET") #'deburr-to-source)
    map))

(define-derived-mode deburr-expanded-mode special-mode "Expanded"
  "Major mode for expanded programs: `RET' goes to the line that made one, `g' expands again."
  (setq-local revert-buffer-function
              (lambda (&rest _)
                (let ((define deburr--define))
                  (with-current-buffer deburr--source (deburr--show define))))))

(defun deburr-expand (&optional words)
  "Show the program that the control would execute, beside the current one.
With a prefix argument ask for WORDS, the values of variables: `Depth=15 Side=1'."
  (interactive (list (and current-prefix-arg (read-string "Values (NAME=VALUE ...): "))))
  (deburr--show (mapcan #'deburr--value (split-string (or words "")))))

(defun deburr-to-source ()
  "Go to the line that made the current one, and say through which calls and passes."
  (interactive)
  (let* ((flat (concat "deburr-expanded:" (string-remove-prefix "file://" (deburr--uri deburr--source))))
         (there (deburr--map deburr--source flat (1- (line-number-at-pos)) deburr--define))
         (ranges (plist-get there :ranges)))
    (when (> (length ranges) 0)
      (pop-to-buffer (find-file-noselect (deburr--path (plist-get there :uri))))
      (deburr--go-to (aref ranges 0))
      (message "%s" (mapconcat #'deburr--frame (plist-get (aref ranges 0) :frames) " <- ")))))

(defun deburr--show (define)
  "Expand the current buffer with the values DEFINE and show what comes of it."
  (let* ((source (current-buffer))
         (uri (deburr--uri source))
         (found (deburr--execute source "deburr.expand" (deburr--with (list :uri uri) define)))
         (there (deburr--map source uri (1- (line-number-at-pos)) define))
         (ranges (plist-get there :ranges)))
    (unless found (user-error "This is no program that deburr knows"))
    (when (string-empty-p (plist-get found :text)) (deburr--complain found))
    (pop-to-buffer (get-buffer-create (format "*expanded: %s*" (buffer-name source))))
    (deburr-expanded-mode)
    (setq deburr--source source deburr--define define)
    (let ((inhibit-read-only t))
      (erase-buffer)
      (insert (replace-regexp-in-string "\r\n?" "\n" (plist-get found :text))))
    (goto-char (point-min))
    (when (> (length ranges) 0) (deburr--go-to (aref ranges 0)))
    (when (eq t (plist-get found :truncated))
      (message "The program is longer than this; it was cut here"))))

(defun deburr--complain (found)
  "Say the first error of FOUND, if there is one, and stop."
  (seq-doseq (each (plist-get found :findings))
    (when (eql 1 (plist-get each :severity))
      (user-error "Not expanded: line %d: %s"
                  (1+ (deburr--line each)) (plist-get each :message)))))

(defun deburr--execute (source command argument)
  "Run a COMMAND of the server of the buffer SOURCE with its ARGUMENT."
  (with-current-buffer source
    (jsonrpc-request (or (eglot-current-server) (user-error "No server; start one with M-x eglot"))
                     :workspace/executeCommand (list :command command :arguments (vector argument)))))

(defun deburr--map (source uri line define)
  "What a LINE of URI, expanded with DEFINE, is on the other side."
  (deburr--execute source "deburr.sourceMap"
                   (deburr--with (list :uri uri :position (list :line line :character 0)) define)))

(defun deburr--with (argument define)
  "ARGUMENT with the values DEFINE, if there are any."
  (if define (append argument (list :define define)) argument))

(defun deburr--value (word)
  "WORD, which is NAME=VALUE, as a property list."
  (unless (string-match "\\`\\([^=]+\\)=\\(.*\\)\\'" word) (user-error "`%s' is not NAME=VALUE" word))
  (list (intern (concat ":" (match-string 1 word))) (match-string 2 word)))

(defun deburr--line (ranged)
  "The line on which the range of RANGED starts."
  (plist-get (plist-get (plist-get ranged :range) :start) :line))

(defun deburr--go-to (ranged)
  "Put point on the line on which RANGED starts."
  (goto-char (point-min))
  (forward-line (deburr--line ranged)))

(defun deburr--frame (frame)
  "A FRAME in words."
  (let ((kind (plist-get frame :kind)))
    (format "%s, %s:%d"
            (if (equal kind "loop") (format "pass %d" (plist-get frame :number)) kind)
            (file-name-nondirectory (deburr--path (plist-get frame :uri)))
            (1+ (plist-get frame :row)))))

(defun deburr--uri (buffer)
  "The URI of the file of BUFFER."
  (funcall (if (fboundp 'eglot-path-to-uri) 'eglot-path-to-uri 'eglot--path-to-uri) (buffer-file-name buffer)))

(defun deburr--path (uri)
  "The file of a URI."
  (funcall (if (fboundp 'eglot-uri-to-path) 'eglot-uri-to-path 'eglot--uri-to-path) uri))

(provide 'deburr)
;;; deburr.el ends here
