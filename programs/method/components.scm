; The kinds of agents that come with Pizarra: why each is a component of its own, and which parts of a wrapper it has
; that its contract does not show. A lab adds its own kinds with ./pizarra method --components FILE.
(component robot (physical) (does transformation interpretation distribution collection processing))
(component vision (physical) (performance) (does transformation interpretation distribution collection processing))
(component pan-tilt (physical) (performance) (abstraction) (does transformation interpretation processing))
(component planner (abstraction) (does transformation interpretation processing))
(component coordinator (performance) (abstraction) (does interpretation distribution collection processing))
(component person (abstraction) (does processing))
(component speech (abstraction) (does interpretation))
(component follower (performance) (does transformation collection))
(component console (abstraction) (does collection distribution))
