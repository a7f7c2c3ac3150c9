;; Who runs where in a cell: its hosts, their agents, the board: see lisp/forms/cell_file.hpp.
;;
;; (hosts-of NODES MISSING ADDED), NODES the sections (host NAME PART ...), answers ((HOST KEY AGENT ...) ...).
;;   A cell without hosts has one. It runs every kind that is not in MISSING, and the agents of ADDED.
;; (scheme-agents-of NODES), NODES the sections (agent NAME PART ...), answers ((NAME FILE MS MB N KEY) ...).
;; (board-of FOUND HOSTS) answers (HOST ADDRESS KEYS). KEYS is the folder of the keys that may come.
;; (refuse-idle NODES AGENTS HOSTS) complains about agents that no host runs.
;; (refuse-agent HOSTS KIND SENTENCE) complains about agents of a kind that has nothing to work with.

(define-module (pizarra hosts)
  #:use-module (srfi srfi-1)
  #:use-module (pizarra forms)
  #:export (hosts-of scheme-agents-of board-of refuse-idle refuse-agent))

;; The one host of a cell that names none runs these.
(define kinds '(robot vision pan-tilt planner coordinator person))
;; A host runs these only where it names them.
(define further-kinds '(speech slave follower))
(define known-kinds (append kinds further-kinds))
;; What `up` runs beside the agents; each has a log of its name, and is on the board under it.
(define processes '(board world log door console arm-plugin camera-plugin narrator))

;; A host's name is part of a folder's name.
(define (host-name? text)
  (and (<= 1 (string-length text) 64)
       (char-set-contains? char-set:letter+digit (string-ref text 0))
       (string-every (char-set-union char-set:letter+digit (char-set #\- #\.)) text)))

(define (host-at node index)
  (let ((name (string-at node index "the host's name")))
    (and name
         (or (and (host-name? name) name)
             (complain! (node-ref node index) 'malformed "a host's name has letters, digits, dashes and dots")))))

;; Another of a kind is called KIND-NUMBER, as vision-2.
(define (kind-of-agent name)
  (let* ((text (symbol->string name))
         (dash (string-rindex text #\-))
         (number (if dash (substring text (+ dash 1)) "")))
    (if (and (positive? (string-length number)) (string-every char-set:digit number))
        (string->symbol (substring text 0 dash))
        name)))

(define (agent-of node added)
  (let ((name (symbol-of node "an agent")))
    (and name
         (if (or (memq name added) (memq (kind-of-agent name) known-kinds))
             name
             (complain! node 'unknown-agent "there is no agent ~a~a" name
                        (suggestion name (append known-kinds added)))))))

;; The parts of a named host: (KEY AGENT-NODE ...), KEY the file of the secret with which it comes to a board elsewhere.
(define (things-of-host host)
  (let* ((found (sections (drop (node-items host) 2) '(agents key)))
         (agents (section-in found 'agents)))
    (cons (text-of-section found 'key "the file of the host's key" "")
          (if agents (node-rest agents) '()))))

;; ADDED are the agents that are Scheme files.
(define (hosts-of nodes missing added)
  (if (null? nodes)
      (list (cons* "localhost" "" (append (lset-difference eq? kinds missing) added)))
      (let* ((named (filter (lambda (node) (host-at node 1)) nodes))
             (things (map things-of-host named)))
        (refuse-repeated named (lambda (node) (node-datum (node-ref node 1))) "a host")
        (refuse-repeated (append-map cdr things) node-datum "a host for the agent")
        (map (lambda (node things-of-it)
               (cons* (node-datum (node-ref node 1)) (car things-of-it)
                      (filter-map (lambda (agent) (agent-of agent added)) (cdr things-of-it))))
             named things))))

;; (agent NAME (scheme "FILE") (time MS) (memory MB) (rate N) (key "FILE")) as (NAME FILE MS MB N KEY), or #f.
(define (scheme-agent-of node)
  (let* ((name (plain-name-at node 1 "the agent's name"))
         (inside (node-within node (if name (string-append "in agent " (symbol->string name)) "in an agent")))
         (found (sections (let ((rest (node-rest inside))) (if (pair? rest) (cdr rest) '()))
                          '(scheme time memory rate key)))
         (file (section-in found 'scheme)))
    (when (and name (memq (kind-of-agent name) known-kinds))
      (complain! (node-ref node 1) 'repeated "the cell has an agent ~a of its own: take another name" name))
    (when (memq name processes)
      (complain! (node-ref node 1) 'repeated "~a is a process that `up` runs by itself: take another name" name))
    (unless file
      (complain-missing! inside '(scheme) "the agent needs its file: (scheme \"FILE\")"))
    (and name file
         (list name
               (or (string-at file 1 "the agent's file") "")
               (first (numbers-in found 'time '((10 60000)) '(1000)))
               (first (numbers-in found 'memory '((8 4096)) '(64)))
               (first (numbers-in found 'rate '((1 100000)) '(1000)))
               (text-of-section found 'key "the file of the agent's key" "")))))

(define (scheme-agents-of nodes)
  (refuse-repeated nodes (lambda (node) (let ((name (node-ref node 1))) (and name (node-datum name)))) "an agent")
  (filter-map scheme-agent-of (at-most nodes 16 "agents that are Scheme files")))

;; Complains about those that no host runs.
(define (refuse-idle nodes agents hosts)
  (for-each (lambda (agent)
              (unless (any (lambda (host) (memq (car agent) (cddr host))) hosts)
                (complain! (find (lambda (node) (eq? (node-datum (node-ref node 1)) (car agent))) nodes)
                           'unknown-agent "no host runs ~a: name it in a host's (agents ...)" (car agent))))
            agents))

;; Complains about every host's agent of this kind, which the cell has nothing for.
(define (refuse-agent hosts refused sentence)
  (for-each (lambda (host)
              (let* ((agents (find (lambda (item) (eq? (node-head item) 'agents)) (node-rest host)))
                     (node (and agents
                              (find (lambda (agent)
                                      (and (symbol? (node-datum agent)) (eq? (kind-of-agent (node-datum agent)) refused)))
                                    (node-rest agents)))))
                (when node (complain! node 'unknown-agent sentence))))
            hosts))

;; (HOST ADDRESS KEYS), KEYS the folder of the keys that may come.
(define (board-of found hosts)
  (let ((board (section-in found 'board)))
    (if board
        (list (or (host-at board 1) "")
              (or (string-at board 2 "the board's address") "")
              (if (> (length (node-items board)) 3)
                  (text-of-section (sections (drop (node-items board) 3) '(keys)) 'keys "the folder of the keys" "")
                  ""))
        (list (if (null? hosts) "localhost" (car (first hosts))) "" ""))))
