# Texts of the panels that belong to one algorithm or a few, in English.

panel-cuts = Cuts
panel-children = Every child
panel-way-down = Way from the root
panel-links = Links
panel-halves = Halving
panel-mid-planes = Mid planes
panel-grid = Finest grid

algorithms-top-down = Top-down
algorithms-bottom-up = Bottom-up, from leaf to leaf
algorithms-grid = On the finest grid
algorithms-reference = Reference

cuts-none = Shows the sorted mid planes once a node is cut.
cuts-middle = middle
cuts-mask = signs
cuts-plane = plane
cuts-inside = cuts
cuts-before = before
cuts-after = after
cuts-piece = piece of t
cuts-child = child

children-none = Shows the tests of all children once a node is entered.
children-order = no.
children-child = child
children-bits = bits
children-interval = t
children-missed = missed

way-down-none = Shows the path from the root once a point is looked for.
way-down-count = search { $n }
way-down-level = level { $level }
way-down-root = root
way-down-exit = exit point
way-down-pushed = pushed to
way-down-target = codes beyond

tables-none = Shows the used entries once a neighbour is looked for.
tables-used = Direction { $direction }, child { $child }.
tables-point = { " " }Point at an entry for its rule.
tables-used-before = Looked up last: direction { $direction }, child { $child }.
tables-bits-before = Read from the bits last: direction { $direction }, child { $child }.
tables-used-bits = Direction { $direction }, child { $child }: read from the bits; the tables say the same.
tables-child = child
tables-yes = yes
tables-up = way up
tables-down = mirrored way down
tables-down-facing = way down
tables-step-up = from child { $child } to level { $level }
tables-step-down = to child { $child }, level { $level }
tables-all = All directions
tables-adjacent-why = Child { $child } has { $bits }. It lies on the side { $direction } of its parent if its bit is 1 where the sign is +, and 0 where it is −.
tables-common-why = Child { $child } has { $bits }. Of { $direction } what stays are the axes along which it lies on that side of its parent: its bit is 1 for +, 0 for −. There the neighbour is beyond the parent.
tables-reflect-why = Child { $child } has { $bits }. The bits of all axes in { $direction } are flipped.

links-none = Shows the links of a leaf once the first one is found.
links-side = side
links-size = neighbour
links-larger = larger leaf
links-equal = leaf
links-divided = divided
links-border = border

mid-planes-none = Shows the comparison with the mid planes once a child is chosen.
mid-planes-point = point
mid-planes-plane = mid plane
mid-planes-bit = bit

halves-none = Shows the plane and its parameter once a part is halved.
halves-near = near half only
halves-far = far half only
halves-both = near, later far
halves-near-why = The ray does not meet the plane between its origin and its exit from the part.
halves-far-why = The ray has met the plane no later than it enters the part.
halves-both-why = The ray meets the plane inside the part: the far half waits on the stack.
halves-gem-near-why = The gem: t is greater than the end of the part, or less than 0.
halves-gem-far-why = The gem: t is less than the start of the part.
halves-gem-both-why = The gem: t is neither greater than the end of the part nor less than 0 or its start. The far half waits on the stack.
halves-gem-nan-why = The gem: t is no number, so that no comparison holds. The far half waits on the stack.

grid-none = Shows the planes ahead once the first cell is found.
grid-count = { $n ->
    [one] 1 cell
   *[other] { $n } cells
}
grid-cell = cell
grid-outside = outside
grid-crossed = through plane { $axes }
