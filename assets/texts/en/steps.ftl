# What happens in each step. Arguments may carry colours: leave them whole.

and = { $first } and { $last }
comma = { $first }, { $last }

by-parametric = the parametric algorithm
by-parametric-table = the parametric algorithm with its tables
by-esvo = the parametric rule without recursion
by-all-children = testing every child
by-hero = HERO's mask and sorted mid planes
by-gargantini = classified pieces between sorted cuts
by-codes = location codes
by-glassner = locating every exit point from the root
by-samet = neighbour tables
by-samet-corner = the corner of its exit planes
by-samet-net = links between neighbours
by-bsp = binary space partition
by-dda = walking through the finest grid
by-dda-octree = looking up the cells of the finest grid
by-exhaustive = testing every leaf by itself

start-ray = A ray from { $origin } along { $direction } is followed through the { $tree } by { $algorithm }.
start-printed-one = { " " }Rule { $rules } is taken as it is printed.
start-printed-many = { " " }Rules { $rules } are taken as they are printed.
start-one-by-one = { " " }Planes that are met at once are crossed one by one.
start-averaged = { " " }The t of a mid plane is the mean of those of the near and the far plane.
start-push = { " " }The exit point is pushed out of each leaf.
start-gem = { " " }The halves are chosen by the comparisons of the gem.
start-point-codes = The leaf that owns the point { $point } is searched by location codes.
start-point-comparison = The leaf that owns the point { $point } is searched by comparing it with mid planes.
start-region = The smallest node that holds a region is searched by location codes.
start-neighbour-tables = The neighbour of { $node } in the direction { $direction } is searched by tables.
start-neighbour = The neighbour of { $node } in the direction { $direction } is searched by location codes.
quadtree = quadtree
octree = octree

clip-hit = The ray crosses the root: it meets the last near plane before the first far plane, { $enter } < { $exit }.
clip-inside = The ray starts inside the root: the last near plane does not come after t = 0, the first far plane does, { $enter } ≤ 0 < { $exit }.
clip-mirror = { " " }Its direction is negative along { $axes }, so state i stands for child f(i) = i xor { $mask }.
clip-mask = { " " }Its direction is negative along { $axes }, so the upper half comes first there: the mask is { $mask }.
clip-falls = { " " }Its direction is negative along { $axes }, so the far planes there are the lower ones.
clip-behind = The ray misses the root, which lies behind its origin: even the first far plane has { $exit } ≤ 0.
clip-miss = The ray misses the root: it meets a far plane no later than the last near plane, { $exit } { $relation } { $enter }.
clip-short = The ray ends before it meets the root, whose last near plane has { $enter }.
clip-no-length = The ray misses the root: it ends at { $end }, no later than it begins.
clip-printed = { $by } the root is hit, from t = { $enter } to t = { $exit }.
by-printed-one = By the printed rule, { $rules },
by-printed-many = By the printed rules, { $rules },
as-printed-one = { " " }So says the printed rule, { $rules }.
as-printed-many = { " " }So say the printed rules, { $rules }.
clip-no-number = { " " }But { $parameters } is no number, so that no comparison with it holds and it decides nothing.
clip-no-numbers = { " " }But { $parameters } are no numbers, so that no comparison with them holds and they decide nothing.
clip-printed-miss = { $by } the root is missed, with t_min = { $enter } and t_max = { $exit }.
clip-parallel = The ray misses the root: it does not move along { $axes }, and its origin lies outside there.

test-hit = { $node } is met between t = { $enter } and t = { $exit }.
test-touch = { $node } is met in one point only, at t = { $at }.
test-miss = { $node } is not met by the ray.
sort = { $n ->
    [0] No leaf is met, so there is nothing to sort.
    [one] Only one leaf is met, so it is in order already.
   *[other] The { $n } leaves that are met are sorted by the t at which the ray enters them.
}

visit-root = The traversal begins at the root, { $node }.
visit-plain = Child { $child } is visited: { $node }.
visit-morton = { $number } is read as x + 2y + 4z, { $rule }, which means child { $child } of the tree; it is visited: { $node }.
visit-mirrored = State { $state } is child { $child }, as f({ $state }) = { $state } xor { $mask } = { $child }; it is visited: { $node }.
skip-behind = The node is left at { $exit } < 0, so it lies behind the origin and is skipped.
skip-ahead = The node is left at { $exit } ≥ 0, so it does not lie behind the origin.
halve = The ray meets the mid planes of the node at { $mid }.
halve-mean = { " " }These are the means of the parameters of the near and far planes.
halve-unselected = { " " }Neither is the smaller one, and the printed rule, { $rule }, has no branch for that: no child is chosen.
halve-still = { " " }It does not move along { $axes }: ∞ there means the lower half for good, −∞ the upper one.
first-one = { $comparisons }, so the { $axes } bit is 1: the ray { $inside ->
    [yes] starts
   *[no] enters
} in the upper { $axes } half, in state { $state }.
first-many = { $comparisons }, so the { $axes } bits are 1: the ray { $inside ->
    [yes] starts
   *[no] enters
} in the upper halves of { $axes }, in state { $state }.
first-printed = { $by } the ray enters in state { $state }.
selection-printed = { $by } the children visited are those of { $states }.
states-one = state { $states }
states-many = states { $states }
first-none = { $comparisons }, so no bit is 1: the ray { $inside ->
    [yes] starts
   *[no] enters
} in state 0.

step-one = { $child } is left at the { $axes } plane: { $exits }, so the { $axes } bit is set: state { $next }.
step-many = { $child } is left at the { $axes } planes at once: { $exits }, so their bits are set: state { $next }.
step-end-one = { $child } is left at the { $axes } plane: { $exits }. In { $done } it is the upper half, so the parent is done, too.
step-end-many = { $child } is left at the { $axes } planes at once: { $exits }. In { $done } it is the upper half, so the parent is done, too.
child = Child { $state }
state = State { $state }
up = { $child } is done: back up to { $node }.
up-behind = { $child } is left at { $exit } ≤ 0, so it lies behind the origin and is skipped: back up to { $node }.
up-none = The root is done.

enter = The ray is in { $node } from t = { $enter } to t = { $exit }.
cuts = { $n ->
    [0] The ray meets no mid plane inside the node, so it stays in one child.
    [one] Of the sorted mid planes, one lies inside the node's interval: { $cuts }.
   *[other] Of the sorted mid planes, { $n } lie inside the node's interval: { $cuts }.
}
classify = At t = { $at }, { $comparisons }: the ray is in child { $child }.
flip-one = At t = { $at } the mid plane of { $axes } is crossed: its bit is flipped, and the next child is { $child }.
flip-many = At t = { $at } the mid planes of { $axes } are crossed at once: their bits are flipped together, and the next child is { $child }.
split-near = { $at } comes no earlier than the exit at { $exit }: the plane is not reached, and only the { $half } is entered.
split-behind = { $at } ≤ 0: the plane is not met after the origin, and only the { $half } is entered.
split-still = The ray does not move along { $axis }: only the half of its origin is entered, the { $half }.
split-far = { $at } comes no later than the entry at { $enter }: the plane is passed, and only the { $half } is entered.
split-both = { $at } lies between { $enter } and { $exit }: the { $half } is entered first, the other one waits on the stack.
split-gem-after = { $at } > { $exit }: the gem takes the half on the side of the origin alone, the { $half }.
split-gem-behind = { $at } < 0: the gem takes the half on the side of the origin alone, the { $half }.
split-gem-far = { $at } < { $enter }: the gem takes the half beyond the plane alone, the { $half }.
split-gem-both = { $at } is neither greater than { $exit } nor less than 0 or { $enter }: the gem takes both halves, first the { $half }; the other one waits on the stack.
split-gem-no-number = { $at } is no number, so that no comparison with { $exit }, 0 or { $enter } holds: the gem takes both halves, first the { $half }; the other one waits on the stack.
upper-half = upper { $axis } half
lower-half = lower { $axis } half
pop-node = From the stack: { $node }, with the ray in it from t = { $enter } to t = { $exit }.
pop-half = From the stack: a part of { $node }, with the ray in it from t = { $enter } to t = { $exit }.
grid = The first cell of the grid is { $cell }; the next planes are met at { $planes }.
cross-one = { $planes }, so the ray crosses the { $axes } plane: on to cell { $cell }.
cross-out-one = { $planes }, so the ray crosses the { $axes } plane and leaves the grid.
cross-out-many = { $planes }, so the ray crosses the planes of { $axes } at once and leaves the grid.
cross-many = { $planes }, so the ray crosses the planes of { $axes } at once: on to cell { $cell }.
tie-first = { " " }Of equal parameters the first axis counts.
tie-last = { " " }Of equal parameters the last axis counts.
parent-all = Child { $child } lies on the side { $direction } of its parent, so the neighbour lies beyond the parent as well: up to { $node }.
parent-part = Of the direction { $direction }, child { $child } lies on the side { $common } of its parent: up to { $node }, and on in that direction.
parent-holds = Child { $child } does not lie on the side { $direction } of its parent, so the parent holds the neighbour: up to { $node }.
mirror = Mirrored, child { $child } becomes child { $mirrored }: down to { $node }.
facing = Child { $child } faces the cell where the search began: down to { $node }.
rope = The link through the { $axis } side leads to { $node }.
rope-spans = { " " }It spans what lies beyond the { $axes } side as well, so no other link is followed there.
rope-border = No link leads through the { $axis } side: it is the border.
push = The exit point { $from } is pushed along { $axis }, to { $to }.

begin-root = The search begins at the root, { $node }.
begin-node = The search begins at { $node }.
encode = The point { $point } has the location codes { $codes } in binary.
encode-ray = Just after t = { $after }, near { $point }, the ray is in the smallest cell with the location codes { $codes } in binary.
compare = { $comparisons }, so the point lies in child { $child }: { $node }.
follow = Bit { $bit } of the codes is { $bits }, which selects child { $child }: { $node }.
follow-printed = { $by } bit { $bit } of the codes is read. It is { $bits }, which selects child { $child }: { $node }.
follow-difference = { $by } bit { $bit } of the differences is read. It is { $bits }, which selects child { $child }: { $node }.
bit-of = { $value } in { $axis }
exits-one = The leaf is left through the plane { $planes }: { $exits }.
exits-many = The leaf is left through the planes { $planes } at once: { $exits }.
target = Beyond it along { $axes }, the codes are { $to } instead of { $from }.
target-printed = { $by } the codes beyond it along { $axes } are { $to }.
border-inside = These codes lie inside the domain, so there is a cell beyond.
border-outside = Along { $axes } the code lies outside the domain, so there is no cell beyond.
border-point-outside = Along { $axes } the point lies outside the domain, so there is no cell beyond.
difference = The codes differ first in bit { $bit }, so the common ancestor has level { $level }.
difference-printed = { $by } the common ancestor has level { $level }. But the codes differ first in bit { $bit }, so it has level { $right }.
difference-none = The codes are equal, so both places lie in one smallest cell, of level 0.
climb = Up to the parent, { $node }; the common ancestor has level { $level }.
climb-done = Up to the parent, { $node }: this is the common ancestor.
leave-one = The leaf is left through its far { $axes } plane: { $exits }.
leave-many = The leaf is left through its far planes of { $axes } at once: { $exits }.
resume = Back to { $node }, which was kept on the way down.
corners = The corners { $min } and { $max } of the region have the codes { $from } and { $to } in binary.

leaf-full = { $node } is on the ray from t = { $enter } to t = { $exit }, and it is occupied.
leaf-printed = { $by } { $node } is reported, from t = { $enter } to t = { $exit }.
leaf-empty = { $node } is on the ray from t = { $enter } to t = { $exit }, and it is empty.
touch-printed = { $by } the walk comes to { $node }, but would leave it at t = { $at }, no later than it enters it: it is not reported.
touch = { $node } is only touched, in one point at t = { $at }.
found-leaf = The search has found { $node }, a leaf.
found-node = The search has found { $node }, which has children.
end-missed = The ray meets no leaf: the traversal ends.
end-left-root = The ray has left the root: the traversal ends after { $n ->
    [one] one leaf
   *[other] { $n } leaves
}.
end-printed = No node is left on the way: the traversal ends after { $n ->
    [one] one leaf
   *[other] { $n } leaves
}.
end-segment = The ray ends here: the traversal ends after { $n ->
    [one] one leaf
   *[other] { $n } leaves
}.
end-cut = The trace ends here, but not the run: it has more than { $n } steps, and no more are kept.
end-looped = The ray gets no further: the same leaves would follow one another for ever, so the traversal is stopped.
end-first-full = The first occupied leaf is reached, and no more was asked for: the traversal ends.
end-found-leaf = The search ends: it has found { $node }, a leaf.
end-found-node = The search ends: it has found { $node }, which has children.
end-outside = The place lies outside the domain: there is nothing to find.
end-outside-axes = The search ends: along { $axes } the neighbour would lie outside the domain, so there is none.

the-node = the node { $code } of level { $level }
the-node-first = Node { $code } of level { $level }
the-leaf = Leaf { $code } of level { $level }

title = { $tree } · { $scene } · { $n ->
    [one] one leaf
   *[other] { $n } leaves
}
title-quadtree = Quadtree
title-octree = Octree
scene-inline = own data

algorithm-parametric = Parametric, by one rule
algorithm-parametric-table = Parametric, by tables
algorithm-esvo = Parametric, iterative
algorithm-all-children = Every child tested
algorithm-hero = HERO: sorted planes
algorithm-gargantini = Gargantini: cuts
algorithm-codes = Location codes
algorithm-glassner = Glassner: from the root
algorithm-samet = Samet: neighbour tables
algorithm-samet-corner = SametCorner (reconstructed)
algorithm-samet-net = SametNet (reconstructed)
algorithm-bsp = Sung–Shirley: binary
algorithm-dda = Amanatides–Woo: grid
algorithm-dda-octree = Grid, looked up in tree
algorithm-exhaustive = Every leaf, exactly

query-ray = Ray
query-point = Point
query-region = Region
query-neighbour = Neighbour

ended-missed = Missed the root
ended-left-root = Left the root
ended-first-full = First occupied leaf
ended-segment-end = End of the segment
ended-cut = Cut off: too many steps
ended-looped = Going round in circles
ended-found = Found
ended-outside = Outside the domain

counter-node-touches = Node touches
counter-leaf-tests = Leaf tests
counter-entry-comparisons = Comparisons, entry
counter-exit-comparisons = Comparisons, exit
counter-range-comparisons = Comparisons, range
counter-code-comparisons = Comparisons, codes
counter-sort-comparisons = Comparisons, sorting
counter-divisions = Divisions
counter-additions = Sums, products
counter-bit-operations = Bit operations
counter-transitions = Transitions
counter-table-lookups = Table look-ups
counter-grid-cells = Grid cells
counter-point-locations = Point locations
counter-ascends = Steps up
counter-descends = Steps down
counter-calls = Recursive calls
counter-stack-depth = Stack depth
counter-leaves = Leaves
counter-touches = Touches

# What becomes of a node, and why.
fate-child = Child { $child }
fate-root = The root
fate-visited-ray = { $who } is visited: the ray is in it from t = { $enter } to t = { $exit }.
fate-visited-point = { $who } holds the point.
fate-entered-ray = { $who } is being searched: the ray is in it from t = { $enter } to t = { $exit }.
fate-entered-point = { $who } is being searched: it holds the point.
fate-ahead-ray = { $who } is not reached yet: the ray is in it from t = { $enter } to t = { $exit }.
fate-ahead-point = { $who } is not reached yet: it holds the point.
fate-passed-ray = { $who } has been passed by, although the ray is in it from t = { $enter } to t = { $exit }.
fate-strayed = { $why } It has been visited all the same.
why-missed = { $who } is not met: { $comparison }, so the ray would leave it through { $exit } before it enters it through { $enter }.
why-touched = { $who } is touched in one point only: { $comparison }.
why-touched-origin = { $who } is touched in one point only, the origin: { $comparison }.
why-behind = { $who } lies behind the origin: it is left at { $comparison }.
why-beside = { $who } lies beside the ray, which does not move along { $axis }: { $comparison }.
why-end = { $who } lies beyond the end of the ray: { $comparison }.
why-full = { $who } is not looked at, as the search ends at the first occupied leaf before it: { $comparison }.
why-elsewhere = { $who } does not hold the point: { $comparison }.
fate-name-visited = visited
fate-name-entered = in search
fate-name-ahead = to come
fate-name-passed = passed by
fate-name-strayed = strayed into
fate-name-missed = not met
fate-name-touched = touched
fate-name-behind = behind
fate-name-beside = beside
fate-name-end = beyond
fate-name-full = not needed
fate-name-elsewhere = elsewhere

# Added to a step of exact comparisons that doubles would have made otherwise.
doubles-differ = { $ulps ->
    [0] { " " }Doubles would err here: both parameters round to the same number.
    [one] { " " }Doubles would err here: they put the parameters 1 ulp apart.
   *[other] { " " }Doubles would err here: they put the parameters { $ulps } ulps apart.
}

heading-step = Step
heading-event = Event
heading-node = Node
heading-t = t
heading-what = What happens
