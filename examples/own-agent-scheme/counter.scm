; counter: counts how often a barrier was blocked, tells the count, and may be asked for it.
;
;   pizarra scheme counter.scm                             joins the cell that runs here; save the file to change it
;   pizarra scheme counter.scm --try counter-test.scm      tries it without a cell
(posts (relation passed ((count integer)) (key)))
(reads (relation barrier ((name symbol) (state symbol)) (key name)))

(define count 0)

(rule count-blocked (barrier ?name blocked)
  (set! count (+ count 1))
  (tell (passed ,count)))

(operation (count) count)
