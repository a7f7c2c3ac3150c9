(use-modules (pizarra cell-test-checks) (pizarra test-checks))

(check "an agent runs on one host"
       (complaint '(host "a" (agents robot)) '(host "b" (agents robot))) '(1 repeated (0 3 2 1)))
(check "a host's name cannot lead out of its folder" (complaint '(host "../a" (agents robot))) '(1 malformed (0 2 1)))
;; The folder of the board's keys, and the hosts.
(define (keys-of . sections)
  (map (lambda (part) (apply cell-part part sections)) '(board-keys hosts)))
(check "a board's folder of keys and a host's own key are named"
       (keys-of '(board "a" "tcp://a:7800" (keys "keys")) '(host "a" (agents robot)) '(host "b" (agents) (key "b.secret")))
       '("keys" (("a" "" robot) ("b" "b.secret"))))
(check "a folder of keys is text" (complaint '(board "a" "tcp://a:7800" (keys 5))) '(1 malformed (0 2 3 1)))
(define (agents-of . sections)
  (cddar (apply cell-part 'hosts sections)))
(check "another agent of a kind is called by its number"
       (agents-of '(host "a" (agents robot vision vision-2 planner-3))) '(robot vision vision-2 planner-3))
(check "a number makes no kind" (complaint '(host "a" (agents robt-2))) '(1 unknown-agent (0 2 2 1)))
(check "another agent needs a device as the first does"
       (complaint '(host "a" (agents robot pan-tilt-2))) '(1 unknown-agent (0 2 2 2)))
;; Agents that are Scheme files.
(define (scheme-agents-of . parts)
  (apply cell-part 'agents parts))
(check "an agent of one's own has a file and limits"
       (list (scheme-agents-of '(agent belt (scheme "b.scm")))
             (scheme-agents-of '(agent belt (scheme "b.scm") (time 50) (memory 16) (rate 10) (key "k"))) (scheme-agents-of))
       '(((belt "b.scm" 1000 64 1000 "")) ((belt "b.scm" 50 16 10 "k")) ()))
(check "the one host runs it"
       (memq 'belt (car (cell-part 'hosts '(agent belt (scheme "b.scm")))))
       '(belt))
(check "hosts that are named must name it"
       (complaint '(agent belt (scheme "b.scm")) '(host "a" (agents robot))) '(1 unknown-agent (0 2)))
(check "an agent has a file" (complaint '(agent belt (time 50))) '(1 malformed (0 2 3)))
(check "an agent has a name of its own"
       (complaint '(agent robot (scheme "b.scm"))) '(1 repeated (0 2 1)))
(check "an agent is called like none of the processes that a cell runs besides"
       (map (lambda (name) (complaint `(agent ,name (scheme "b.scm"))))
            '(board world log door console arm-plugin camera-plugin narrator))
       (make-list 8 '(1 repeated (0 2 1))))
(check "no two agents have one name"
       (complaint '(agent a (scheme "b.scm")) '(agent a (scheme "c.scm"))) '(1 repeated (0 3)))
(check "limits are within their bounds" (complaint '(agent a (scheme "b.scm") (time 5))) '(1 out-of-range (0 2 3 1)))

(finish-checks)
