# Degenerate rays: their names, what is to be watched on them, and how a ray
# becomes one.

gallery-axis-parallel = Parallel to an axis
watch-axis-parallel = The other axes never take part: their parameters are −∞ and ∞, and no plane of theirs is ever crossed.
gallery-face-plane = In the plane of a face
watch-face-plane = Each cell owns its lower plane, so the ray runs through the upper neighbours alone and no leaf is visited twice.
gallery-lower-face = In the lower face of the root
watch-lower-face = The root owns its lower face: the ray is inside, although it only slides along the surface.
gallery-upper-face = In the upper face of the root
watch-upper-face = The root does not own its upper face: the ray misses, without any touch.
gallery-edge = Along an edge
watch-edge = Four cells share the edge; the one that owns it is above in both axes, and only it is visited.
gallery-corner = Through a corner
watch-corner = All planes of the corner are crossed at once: the next leaf lies diagonally opposite, those between are merely touched.
gallery-centre = Through the centre
watch-centre = All mid planes of the root are met at the same t: the automaton goes straight from state 0 to the last one.
gallery-diagonal = Down the main diagonal
watch-diagonal = The mirror mask has all its bits: the states are those of the rising diagonal, the children are counted from the other end.
gallery-negative-zero = A component −0
watch-negative-zero = Minus zero counts as zero: whoever divides by it gets infinities of the wrong sign, or 0/0 in the plane where the ray lies.
gallery-tiny = A component of 10⁻⁷
watch-tiny = The parameters of the slow axis are seven orders of magnitude larger: the ray starts on a plane and leaves it at once, so it is not parallel.
gallery-on-face = Origin on a face
watch-on-face = The origin belongs to the upper cell but the ray moves down: the first leaf is the one below.
gallery-on-corner = Origin on a corner
watch-on-corner = Only one of the cells around the origin is ahead of the ray: the signs of the direction tell which.
gallery-inside = Origin inside the root
watch-inside = Near planes lie behind the origin, with t below 0: the first leaf is entered at t = 0.
gallery-behind = The root lies behind
watch-behind = The line meets the root, but for t below 0 only: the ray misses.
gallery-leaving = Leaving at once
watch-leaving = The origin is in the lower face of the root and the ray goes outwards: it is inside for no length at all.
gallery-grazing = Grazing the root
watch-grazing = The ray meets the root in a single point: entry and exit are equal, so no leaf is visited.
gallery-miss = Past the root
watch-miss = The last near plane comes after the first far plane: the ray is never between all planes at once.
gallery-lattice = Tie of two axes
watch-lattice = One axis rises and one falls, and they reach their planes at the same t: both bits change in one step.
gallery-lattice-space = Tie of three axes
watch-lattice-space = Three planes are crossed at the same t with three different slopes: the step goes to the leaf across the corner.
gallery-thirds = Thirds that doubles round
watch-thirds = The direction is a third of a lattice vector, rounded: compare exactly and see where doubles find a tie that is none, or none where there is one.
gallery-far = From a million sides away
watch-far = Most digits of t are spent on the distance: doubles would lose the small cells, so from so far away comparisons are exact even where doubles are chosen.
gallery-slow = Almost no speed
watch-slow = t is of the order of 10³⁰⁰: nothing may be squared or compared with a fixed tolerance.
gallery-none = In this tree the numbers of such a ray are no doubles.

snap-zero-component = The smallest component of the direction is 0 now: nothing is crossed along this axis any more.
snap-axis-parallel = The ray is parallel to an axis now.
snap-diagonal = The components of the direction are equal now: planes are met in step.
snap-through-corner = The ray meets a corner exactly now, at t = 1.
snap-origin-on-plane = The origin lies on a plane of the tree now: the direction tells the side.
snap-origin-on-corner = The origin is a corner of the tree now: the signs of the direction tell the leaf.
