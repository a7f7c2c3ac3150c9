; Facts that others tell counter, and the facts that it is expected to tell.
(tell (barrier exit blocked))
(expect (passed 1))
(tell (barrier exit free))
(tell (barrier exit blocked))
(expect (passed 2))
(call (count) (2))
