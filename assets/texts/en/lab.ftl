# Texts of the bench lab, in English.

lab-name-batch = Batch, vectors
lab-name-batch-plain = Batch, plain
lab-quantity-time = Time a ray
lab-quantity-time-per-leaf = Time a leaf
lab-quantity-steps = Steps a ray
lab-quantity-node-touches = Node touches
lab-quantity-comparisons = Comparisons
lab-quantity-lines = Lines of memory
lab-quantity-cache-misses = Cache misses
lab-quantity-branch-misses = Wrong predictions
lab-quantity-cells = Cells along an axis
lab-quantity-tree-leaves = Leaves of the tree
lab-quantity-ray-leaves = Leaves on the ray
lab-unit-time = µs a ray
lab-unit-time-per-leaf = ns a leaf
lab-unit-steps = steps a ray
lab-unit-node-touches = touches a ray
lab-unit-comparisons = comparisons a ray
lab-unit-lines = lines of 64 bytes a ray
lab-unit-cache-misses = misses of 32 KiB a ray
lab-unit-branch-misses = wrong predictions a ray
lab-unit-cells = cells along an axis (2 to the depth)
lab-unit-tree-leaves = leaves of the tree
lab-unit-ray-leaves = leaves on the ray
lab-best = best { $value }
lab-scenes-note = Depth { $depth }. Each bar as a multiple of the best, whose value stands at the right of the scene ({ $unit }); the scale is logarithmic.
lab-growth-note = { $scene }. Behind each name stands e: the cost grows as the size to the power of e (fitted by least squares to the logarithms).
lab-measured-once = { " " }Measured once only: repeat it before you trust the times.
lab-side-by-side = { " " }Curves that coincide are drawn side by side.
lab-nothing = Nothing is measured yet: choose at the left, and press Measure.
lab-no-site = { $scene } was not measured at depth { $depth }.
lab-uncounted = There is no such number here.
lab-no-algorithm = Choose an algorithm to watch it on the ray.
lab-one-depth = Measure at two depths or more to see how costs grow.
lab-statement = statement
lab-published = published
lab-here = here
lab-nodes = touches
lab-comparisons = comparisons
lab-holds = holds here
lab-about-one = about 1
lab-holds-agrees = yes
lab-holds-same-side = only the order
lab-holds-differs = no
lab-holds-not-measured = not measured
lab-published-note = How to read the numbers: the time of the first algorithm divided by that of the second, as the geometric mean over the scenes of the statement and all measured depths. Node touches and comparisons are divided in the same way.
lab-verdict-none = None of the published statements is about what was measured.
lab-verdict =
    { $measured ->
        [one] One published statement was measured
       *[other] { $measured } published statements were measured
    }: { $agrees ->
        [0] none holds here
        [one] one holds here
       *[other] { $agrees } hold here
    }{ $side ->
        [0] { "" }
        [one] , one names the faster algorithm rightly but not by how much
       *[other] , { $side } name the faster algorithm rightly but not by how much
    }{ $differs ->
        [0] { "" }
        [one] , one does not hold
       *[other] , { $differs } do not hold
    }.
lab-why-agrees = “{ $of }” takes { $here } times as long as “{ $against }”{ $place }; the published factor is { $published }.
lab-why-same-side = “{ $of }” takes { $here } times as long as “{ $against }”{ $place }; the published factor is { $published }. So the same one is faster here, but by another factor: it touches { $nodes } times as many nodes and makes { $comparisons } times as many comparisons.
lab-why-differs = “{ $of }” takes { $here } times as long as “{ $against }”{ $place }; the published factor is { $published }. It touches { $nodes } times as many nodes and makes { $comparisons } times as many comparisons; what these cost depends on the processor, the compiler and how the tree lies in memory.
lab-sources = Revelles, Ureña and Lastra (2000) found the parametric algorithm about as fast as Gargantini’s, and the octree faster than the BSP tree by 10.4, 12.7 and 6.8 %. Havran (1999) found Samet’s algorithm faster than Gargantini’s, in the geometric mean of nine other scenes. Of all their scenes only size and kind are known; ours are made from a seed.
lab-memory = Reads from memory
lab-branches = Decisions
lab-reads = { $n } reads in { $lines } lines of 64 bytes
lab-guesses = { $n } decisions, { $wrong } predicted wrongly
lab-cut = (only the beginning)
lab-processor-note = How a processor would follow the ray that is shown, one stroke for each read and each decision in their order. Its cache begins empty, and its branch prediction knows nothing yet. Memory is fetched in lines of 64 bytes; a wrong prediction costs about 15 cycles. Decisions are the places where a program branches: unlike the comparisons of the counters they include the tests for a leaf, and the test of a whole box is one.
lab-kinds = Predicted wrongly, of all decisions, by what is asked
lab-kind-leaf = a leaf?
lab-kind-entry = entry
lab-kind-exit = exit
lab-kind-range = in range?
lab-kind-sort = order
lab-kind-climb = climb on?
lab-title = Bench lab
lab-tab-scenes = Scenes
lab-tab-growth = Growth
lab-tab-published = Published
lab-tab-table = Table
lab-tab-processor = Memory and predictions
lab-scenes = Scenes
lab-algorithms = Algorithms
lab-depths = Depths
lab-to = to
lab-least-depth = Least depth
lab-most-depth = Greatest depth
lab-rays = Rays
lab-repeats = Repetitions
lab-seed = Seed
lab-run = Measure
lab-running = Measuring
lab-stop = Stop
lab-all = all
lab-none = none
lab-paper = those of the paper
lab-nothing-chosen = Choose a scene and an algorithm.
lab-disagrees = In { $scene } at depth { $depth } { $method } finds other leaves than { $reference }, first on ray { $ray }.
lab-agree = All algorithms have found the same leaves.
lab-unoptimised = This program was built without optimisation: its times tell nothing, its counts do.
lab-not-built = Scenes and depths whose trees cannot be built are left out: { $names }
lab-stopped = Stopped; what was measured until then is shown.
lab-quantity = Shown
lab-against = against
lab-scene = Scene
lab-depth = Depth
lab-save = Save as
lab-chart-svg = Chart as SVG
lab-chart-pdf = Chart as PDF
lab-chart-png = Chart as PNG
lab-chart-tex = Chart as TikZ
lab-table-csv = Table as CSV
lab-table-md = Table as Markdown
lab-left-out = Left out where the tree is too large: { $names }
lab-site = { $scene }, depth { $depth }: { $leaves } leaves, { $rays } rays
lab-cached = in the cache
lab-uncached = from main memory
lab-predicted = predicted rightly
lab-mispredicted = predicted wrongly
lab-depth-n = depth { $depth }
lab-algorithm = algorithm
lab-times = Time
lab-computed = Node touches, comparisons and divisions
lab-way = Way through the tree, and what it costs a processor
lab-table-note = Means of a ray; of the stack the greatest depth. Lines are those of 64 bytes of memory. ± % is half the distance of the quartiles of all repetitions; a single one has none.
lab-column-time = µs/ray
lab-column-spread = ± %
lab-column-time-per-leaf = ns/leaf
lab-column-rate = rays/s
lab-column-of-best = × best
lab-column-codes = codes
lab-column-divisions = divisions
lab-column-locations = located
lab-column-up = up
lab-column-down = down
lab-column-stack = stack
lab-column-lines = lines
lab-column-uncached = not cached
lab-column-misguessed = mispredicted
