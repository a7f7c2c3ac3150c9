; What others tell counter, and what is expected of it.
(tell (barrier exit blocked))
(expect (passed 1))
(tell (barrier exit free))
(tell (barrier exit blocked))
(expect (passed 2))
(call (count) (2))
