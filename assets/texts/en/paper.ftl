# Errata of “Ray Tracing mit Octrees”: what is printed, what is right, and why.

erratum-b-1-title = Interval of a ray in a node
erratum-b-1-printed = t_min = min(t_x0, t_y0), t_max = max(t_x1, t_y1)
erratum-b-1-right = t_min = max(t_x0, t_y0), t_max = min(t_x1, t_y1)
erratum-b-1-why = The ray is in the node while it is between the planes of every axis: the intervals have to overlap. As printed, every ray with d > 0 hits.

erratum-b-2-title = Table 2: bits of the first child
erratum-b-2-printed = t_xm < t_z0 sets bit 0, and t_zm sets bit 2
erratum-b-2-right = x sets bit 2, y bit 1, z bit 0
erratum-b-2-why = Table 3 and the mask a = 4a_x + 2a_y + a_z have x as the highest bit. With the bits interchanged the walk begins in a wrong child. Read as x + 2y + 4z (B-2-morton), it begins in the right one, but table and mask then lead astray.
reading-b-2 = as printed
reading-b-2-morton = states read as x + 2y + 4z

erratum-b-3-title = Selection of children in the plane
erratum-b-3-printed = q_1 in both branches; q_3 if t_ym < t_y1; nothing for t_xm = t_ym
erratum-b-3-right = q_2 if t_xm < t_ym; then q_3 if t_ym < t_x1; q_0 and q_3 if t_xm = t_ym
erratum-b-3-why = In the second branch q_1 is the wrong cell, as the ray is in the lower half along y, and t_ym < t_y1 always holds, so q_3 is always reported. A ray through the centre gets no child at all.

erratum-b-4-title = Parameter of the mid plane
erratum-b-4-printed = t_xm = (t_x0 + t_x) / 2, computed for each child
erratum-b-4-right = t_xm = (t_x0 + t_x1) / 2, computed once for each parent
erratum-b-4-why = The index 1 is missing. Read as t_x0, the mid plane falls on the near plane. All children of a node share the two (three) values.

erratum-b-5-title = Division by zero on a plane
erratum-b-5-printed = x / 0 = ∞ for x > 0 and −∞ for x < 0; x = 0 is missing
erratum-b-5-right = x / 0 = −∞ for x = 0 as well
erratum-b-5-why = A cell owns its lower plane. With 0 / 0 = NaN no comparison holds, and a ray in the upper face of the root counts as a hit.

erratum-b-6-title = Mid plane of an axis without motion
erratum-b-6-printed = Eq. 15 needs x_0 and x_1, which a recursion by parameters alone does not carry
erratum-b-6-right = t_xm = ∞ for p_x below the mid plane, else −∞
erratum-b-6-why = Eq. 13 alone gives −∞ + ∞ = NaN, no comparison holds, and the ray ends up in the lower halves. The node's box has to be carried along.

erratum-b-7-title = Mirrored origin
erratum-b-7-printed = p' = s − p
erratum-b-7-right = p' = x_0 + x_1 − p
erratum-b-7-why = The mirror is the plane through the root's centre. s − p, with the root's side s, is the same only if its minimum corner is at 0.

erratum-b-8-title = Words of the mirroring
erratum-b-8-printed = Mirrored at the e axis; image range; unnumbered
erratum-b-8-right = Mirrored at the mid plane across e; list of the values f(0) … f(7); renumbered
erratum-b-8-why = Only the coordinate along e changes. The numbers themselves are right.

erratum-b-9-title = Child 7 as the first
erratum-b-9-printed = Every child but 7 can be the first
erratum-b-9-right = True for origins outside; from inside child 7 can be the first: entry = max(t_x0, t_y0, t_z0, 0)
erratum-b-9-why = Without the 0 the walk begins at the near planes, behind the origin, and has to skip children until it comes to 7.

erratum-b-10-title = The ray begins at t = 0
erratum-b-10-printed = t_min < t_max alone is a hit
erratum-b-10-right = t_min < t_max and t_max > 0; children with t_1 < 0 are skipped
erratum-b-10-why = A root behind the origin has t_min < t_max, too. Nodes behind the origin would be reported.

erratum-b-11-title = Closed or half-open cells
erratum-b-11-printed = ≤ in some formulas, < in others
erratum-b-11-right = x_0 ≤ x < x_1 and t_min < t_max everywhere
erratum-b-11-why = With ≤ neighbours share points, and a ray that touches only a corner of the root is a hit.

erratum-b-12-title = Directions with a zero
erratum-b-12-printed = d ≥ 0 in one place, d > 0 in another
erratum-b-12-right = d > 0 up to the section on zeros, d ≥ 0 after it
erratum-b-12-why = Eq. 5 divides by d. The direction need not be normalised: t is then no length, but the order is the same.

erratum-b-13-title = Entry point
erratum-b-13-printed = Entry point t_0 = (t_x0, t_y0)
erratum-b-13-right = Two parameters of planes; the entry is at max(t_x0, t_y0)
erratum-b-13-why = A point has coordinates. Here are two values of t, and the later one is where the ray comes in.

erratum-b-14-title = A reference to formulas
erratum-b-14-printed = (4) put into (5)
erratum-b-14-right = (5) put into (6)
erratum-b-14-why = The parameters of eq. 5 go into the condition of eq. 6.

erratum-b-15-title = Another reference
erratum-b-15-printed = Follows from (2); t_x1(k) without the ray
erratum-b-15-right = Follows from (3); t_x1(k, r)
erratum-b-15-why = The condition on the parameters stands in eq. 3, and a parameter belongs to a node and a ray.

erratum-b-16-title = Order of the steps
erratum-b-16-printed = Test eq. 11, then compute the parameters
erratum-b-16-right = Compute the parameters, then test; children in the order of the ray
erratum-b-16-why = A comparison needs its operands first. A failed test means that the ray misses the node, not the whole octree.

erratum-b-17-title = Ties in Tables 1 and 3
erratum-b-17-printed = Nothing about two equal exit parameters
erratum-b-17-right = Set the bits of all axes with the least parameter
erratum-b-17-why = The tables are right. One axis at a time also walks through cells that the ray only touches.

erratum-b-18-title = Which bit comes first
erratum-b-18-printed = Codes in the format “least significant bit first”
erratum-b-18-right = Ordinary binary numbers; the bit of the highest branch is used first
erratum-b-18-why = Only the numbering of the bits begins at the right. 001000 read from the right is 000100, another cell.

erratum-b-19-title = Bit of a level
erratum-b-19-printed = On level k bit k is used
erratum-b-19-right = In a node of level k bit k − 1 of every code is used
erratum-b-19-why = Bit k tells the way from level k + 1 to level k. Bit R of every code is 0, so that the first step would always go to the lower half.

erratum-b-20-title = Level 0 and the number of bits
erratum-b-20-printed = Leaves form level 0; as many bits as levels
erratum-b-20-right = Level 0 has the smallest possible cells; leaves lie on any level; N levels are N − 1 branches
erratum-b-20-why = The top bit of a code is always 0. It is the domain that is normalised, not the values of the nodes.

erratum-b-21-title = Coordinate 1.0
erratum-b-21-printed = Points in [0..1]
erratum-b-21-right = Points in [0, 1)
erratum-b-21-why = With six levels 1.0 has the code 100000. All bits that are used are 0, so that the point silently ends in the leftmost cell.

erratum-b-22-title = Comparisons saved
erratum-b-22-printed = Two a level in a quadtree, four in an octree
erratum-b-22-right = Two in a quadtree, three in an octree
erratum-b-22-why = One comparison an axis. From level 7 down to 0 these are 7 · 3 = 21 comparisons and 8 leaf tests.

erratum-b-23-title = Corner that the code describes
erratum-b-23-printed = Upper left corner
erratum-b-23-right = Minimum corner: left, bottom, back
erratum-b-23-why = With y upwards the smallest coordinates are at the bottom.

erratum-b-24-title = Region location
erratum-b-24-printed = Level = number of the first common 1; descend by the XOR codes
erratum-b-24-right = Level = number of the highest 1 in any XOR code + 1; descend by the codes of a point of the region
erratum-b-24-why = Bit k separates cells below level k + 1. One axis is enough to part the corners, and a difference says nothing about the place. All zeros mean level 0.
reading-b-24a = the level is the number of the bit itself
reading-b-24b = the first 1 common to all differences counts
reading-b-24c = descends by the differences

erratum-b-25-title = Common ancestor
erratum-b-25-printed = Climb until the first binary digit of the difference code is 0
erratum-b-25-right = Climb until the bit at the current level is 0, from the level of the cell on
erratum-b-25-why = The bits that differ form a run upwards from the cell's level. The leftmost digit is always 0, so that one never climbs. The rightmost one never changes: where it is 1 one climbs to the root.
reading-b-25-leftmost = the leftmost digit counts
reading-b-25-rightmost = the rightmost digit counts

erratum-b-26-title = What HERO tests
erratum-b-26-printed = HERO tests all possible children one after the other
erratum-b-26-right = HERO generates only the children on the ray, in order
erratum-b-26-why = Mask and sorted mid planes give their order at once. Testing all children is the simple method of section 4.1.

erratum-b-27-title = Bottom-up and top-down
erratum-b-27-printed = Sam, SamC, SamN are top-down, Gar is bottom-up
erratum-b-27-right = Sam, SamC, SamN are bottom-up, Gar is top-down
erratum-b-27-why = Samet's methods climb from a leaf to its neighbour. Gargantini's begins at the root and needs no neighbours.

erratum-b-28-title = Code of the lower neighbour
erratum-b-28-printed = Differs by the side length to either side
erratum-b-28-right = Upper side: code + side length; lower side: code − 1; outside 0 … 2^R − 1 there is none
erratum-b-28-why = The size beyond is unknown, but the smallest cell next to the side lies in every neighbour. A step by the side length jumps over smaller ones.

erratum-b-29-title = First leaf with something in it
erratum-b-29-printed = The first leaf that is not empty has the hit
erratum-b-29-right = Go on until a hit lies between entry and exit of its leaf
erratum-b-29-why = An object in a leaf may be missed, or be hit outside this leaf, behind another object.

erratum-b-30-title = Parents and children
erratum-b-30-printed = Every node has a parent and children
erratum-b-30-right = All but the root have a parent, all but the leaves have children
erratum-b-30-why = The root is where the way down begins, leaves are where it ends.

erratum-b-31-title = Where point location ends
erratum-b-31-printed = At the lowest level
erratum-b-31-right = At a leaf, on any level; what is compared are the mid planes
erratum-b-31-why = Large leaves lie above the lowest level.

erratum-b-32-title = Parts of the paper
erratum-b-32-printed = Three chapters, a second and a last part
erratum-b-32-right = The sections as they are numbered
erratum-b-32-why = The words of the introduction do not match the sections.

erratum-b-33-title = Ray traversal by codes
erratum-b-33-printed = No word on where the next codes come from
erratum-b-33-right = From the code and the side length of the leaf itself
erratum-b-33-why = That is the point of the report: neither a walk in smallest steps nor a stack.

erratum-b-34-title = Letters for a node
erratum-b-34-printed = k in the text, o in Table 2, q in the rule for the plane
erratum-b-34-right = One letter for one thing
erratum-b-34-why = All three are nodes.

erratum-b-35-title = References
erratum-b-35-printed = Several names, years and titles
erratum-b-35-right = Frisken, S. F.; Lastra, M.; Havran 1999; Amanatides; Endl and Sommer 1994; Gargantini
erratum-b-35-why = They were copied with errors; a work that is cited is missing from the list.

erratum-b-36-title = Comparison with the BSP tree
erratum-b-36-printed = The explanation stands as a fact
erratum-b-36-right = It is the authors' own; Havran calls the comparison unfair
erratum-b-36-why = A single kind of regular scene suits regular structures.

erratum-b-37-title = Speed of Gargantini's method
erratum-b-37-printed = About as fast as Samet's
erratum-b-37-right = In Havran's own measurements Samet's was faster
erratum-b-37-why = Which method wins depends on machine and code.
