# Texts of the window, in English.

menu-all = Menu
menu-file = File
menu-edit = Edit
menu-view = View
menu-panels = Panels
menu-show = Picture
menu-ray = Ray
menu-gallery = Gallery of degenerate rays
menu-step = Step
menu-help = Help

command-open = Open…
command-save = Save
command-save-as = Save as…
command-export = Export the view…
command-quit = Quit
command-undo = Undo
command-redo = Redo
command-preset-bits = Geometry and bits
command-preset-rail = Geometry and t-rail
command-preset-automaton = Geometry and automaton
command-preset-debug = Debug
command-preset-compare = Compare the algorithms
command-preset-lecture = Lecture
command-question = Scene, ray and query
command-preset-tree = Geometry and tree
command-preset-map = Geometry and map of rays
command-restore-panels = Restore this arrangement
command-frame-all = Show everything
command-stand-node = Go to the current node
command-stand-right = View from the right, along x
command-stand-front = View from the front, along y
command-stand-above = View from above, along z
command-next-lens = Perspective or parallel
command-reduced-motion = Reduced motion
command-show-order-numbers = Show order numbers
command-show-content = Show the content
command-show-empty-leaves = Show empty leaves
command-show-inner-nodes = Show inner nodes, not leaves alone
command-show-ancestors = Show the ancestors
command-show-children = Show the children
command-show-mirrored-ray = Show the mirrored ray
command-show-half-open-sides = Show half-open sides
command-show-codes = Show codes on cells
command-show-apart = Move the children apart
command-next-rest = Cells off the path: plain, faint or hidden
command-fewer-small = Leave out the smallest cells
command-more-small = Show smaller cells
command-fewer-large = Leave out the largest cells
command-more-large = Show larger cells
command-all-levels = Show cells of all levels
command-next-slice = Cut the octree open: off, across x, y or z
command-slice-down = Move the cut down its axis
command-slice-up = Move the cut up its axis
command-follow = Follow the current node
command-formulas = Show formulas
command-next-notation = Next notation of formulas
command-next-theme = Next theme
command-next-language = Deutsch
command-scale-up = Larger
command-scale-down = Smaller
command-scale-reset = Normal size
command-full-screen = Full screen
command-blank = Blank the screen
command-reverse-ray = Turn the ray round
command-snap-ray = Make the ray degenerate
command-next-degenerate = Next ray of the gallery
command-back-to-ray = Back to the ray
command-step-forward = Step forward
command-step-back = Step back
command-next-leaf = To the next leaf
command-previous-leaf = To the previous leaf
command-first = To the beginning
command-go-to-step = Go to step…
command-first-wrong = To the first wrong step
command-last = To the end
command-play = Play or pause
command-faster = Play faster
command-slower = Play slower
command-spotlight = Spotlight
command-notes = Notes for the second screen
command-lab = Bench lab…
command-find = Find a command…
command-keys = Keys
command-about = About Octoscope

key-ctrl = Ctrl
key-shift = Shift
key-page-up = Page Up
key-page-down = Page Down
key-home = Home
key-end = End
key-space = Space

panel-scene = Scene
panel-ray = Ray
panel-query = Query
panel-show = Show
panel-codes = Codes
panel-region = Region by XOR
panel-neighbour = Neighbour
panel-t-rail = t-rail
panel-automaton = Automaton
panel-listing = Listing
panel-variables = Variables
panel-stack = Stack
panel-counters = Counters
panel-paper = Paper lab
panel-tables = Neighbour tables
panel-compare = Comparison
panel-tree = Tree
panel-why-not = Why not?
panel-map = Map of rays
panel-menu = Panel { $title }
panel-fold = Fold
panel-unfold = Unfold
panel-up = Move up
panel-down = Move down
panel-close = Close
space-name = Space view
space-click-neighbour = Click: the neighbour beyond
space-ray-away = How far the origin of the ray is from the root: it lies beyond the picture

scene-source = What the tree is built from
scene-inline = own data
scene-depth = depth
scene-capacity = capacity
scene-threshold = threshold
scene-quadtree-82 = 82 points in the plane
scene-figure-1 = Figure 1: a binary tree
scene-checker-cells = Chequered cells
scene-rings = Picture with rings
scene-figure-7 = Figure 7: a mirrored ray
scene-points-3d = 300 points in space
scene-sphere-grid = Grid of spheres
scene-cloud = Cloud of 1890 spheres
scene-cylinders = 4320 cylinders and spheres
scene-objects = 4350 objects
scene-spheres-512 = 512 spheres
scene-spheres-4096 = 4096 spheres
scene-spheres-32768 = 32768 spheres
scene-counts-points = { $items ->
    [one] 1 point
   *[other] { $items } points
}, { $leaves ->
    [one] 1 leaf
   *[other] { $leaves } leaves
}
scene-counts-cells = { $items ->
    [one] 1 cell
   *[other] { $items } cells
}, { $leaves ->
    [one] 1 leaf
   *[other] { $leaves } leaves
}
scene-counts-image = { $items ->
    [one] 1 pixel
   *[other] { $items } pixels
}, { $leaves ->
    [one] 1 leaf
   *[other] { $leaves } leaves
}
scene-counts-spheres = { $items ->
    [one] 1 sphere
   *[other] { $items } spheres
}, { $leaves ->
    [one] 1 leaf
   *[other] { $leaves } leaves
}
scene-counts-boxes = { $items ->
    [one] 1 box
   *[other] { $items } boxes
}, { $leaves ->
    [one] 1 leaf
   *[other] { $leaves } leaves
}
scene-counts-triangles = { $items ->
    [one] 1 triangle
   *[other] { $items } triangles
}, { $leaves ->
    [one] 1 leaf
   *[other] { $leaves } leaves
}

ray-origin = origin
ray-direction = direction
number-missing = A number is missing: write one such as −0.25, 3/4, 1e-3 or 0x1.8p-1.
number-refused = “{ $typed }” is no number: write one such as −0.25, 3/4, 1e-3 or 0x1.8p-1.
whole-refused = “{ $typed }” is no whole number from { $least } to { $most }: write one.
range-refused = “{ $typed }” is no number from { $least } to { $most }: write one.
number-meanwhile = Until then { $value } holds; Esc brings it back.
number-restored = { $value } holds again.
ray-refused = A ray needs a direction other than zero; the last one stays.

query-ray = Ray
query-point = Point
query-region = Region
query-region-from = from
query-region-to = to
query-neighbour = Neighbour
query-algorithm = Algorithm
query-first-full = stop at the first full leaf
query-first-full-why = The traversal ends at the first occupied leaf, as for the nearest hit of a ray tracer.
query-rules-why = Rules that can be followed in another form: as a paper did otherwise, or as the seminar paper prints them wrong.
query-rules = Rules{ $n ->
    [0] {""}
   *[other] {" "}({ $n })
}
query-rules-none = No rule of this algorithm comes in another form.
query-segment-end = end at t
variant-one-by-one = one plane at a time
variant-one-by-one-why = Of planes that are met at once only one is crossed: cells are touched on the way.
variant-averaged = averaged mid planes
variant-averaged-why = The t of a mid plane is the mean of those of the near and the far plane, as in equation 13, rounding included.
variant-push = push the exit point
variant-push-why = On by half a smallest cell along the normal of the exit face, as Glassner did it; near edges it may go round in circles.
variant-gem = compare as in the gem
variant-gem-why = As Sung and Shirley printed it: equal parameters and an origin on the plane are not settled.
query-point-hint = Click a cell or drag the point to locate it. Esc goes back to the ray.
query-region-hint = Drag a box over the cells, or a corner of it. Esc goes back to the ray.
query-neighbour-hint = Click near a side of a cell, or pick a direction. Esc goes back to the ray.
arithmetic-doubles = doubles
arithmetic-doubles-why = Parameters t are 64-bit floating-point numbers and round, as in a usual program.
arithmetic-exact = exact
arithmetic-exact-why = Parameters t are compared as exact fractions; the steps tell where doubles would err.
arithmetic-fixed-why = Every leaf is always tested exactly: the result is what other algorithms are measured against.
point-codes = by codes
point-comparison = by comparison
reach-equal = equal or larger
reach-leaf = leaf
reach-every-leaf = all leaves
neighbour-codes = by codes
neighbour-tables = by tables
neighbour-cell = cell of level { $level }, codes { $codes }
neighbour-direction = direction

show-order-numbers = order numbers
show-half-open-sides = half-open sides
show-codes = codes
show-mirrored-ray = mirrored ray
show-content = content
show-empty-leaves = empty leaves
show-ancestors = ancestors
show-children = children
show-order-numbers-why = The numbers of the visited leaves, in their order along the ray
show-half-open-sides-why = Every cell owns its lower sides but not its upper ones; the sides it does not own are dashed
show-codes-why = Location codes, written into the cells
show-mirrored-ray-why = The ray turned so that no component is negative, as the parametric algorithm follows it
show-content-why = The points, the picture or the solids from which the tree is built
show-empty-leaves-why = Leaves that hold nothing
show-ancestors-why = Nodes from the root to the current one
show-children-why = Children of the current node, those ruled out dashed
show-more-plane = which cells, how far apart
show-more-space = which cells, cut, how far apart
show-inner-nodes = inner nodes
show-inner-nodes-why = Inner nodes off the path too, not leaves alone
show-levels = levels
show-levels-why = Levels of the cells off the path; 0 is that of the smallest
show-levels-least = smallest level shown
show-levels-most = largest level shown
show-rest = other cells
show-rest-why = How the cells off the path are drawn
show-rest-plain = plain
show-rest-plain-why = Cells off the path as they are
show-rest-faint = faint
show-rest-faint-why = Cells off the path as faint lines
show-rest-hidden = hidden
show-rest-hidden-why = The path alone
show-slice = cut
show-slice-why = A plane that cuts the octree open: what lies before it is left out, but for the path
show-slice-off = off
show-slice-off-why = The whole octree
show-slice-across = Cut across the { $axis } axis
show-slice-at = place of the cut
show-apart = apart
show-apart-why = How far the children of the current node are moved apart, in their own sides

stack-empty = Nothing is on the stack.
stack-level = level
stack-codes = codes
stack-state = state
stack-half = half
stack-whole = whole
stack-interval = t
compare-sort = Sort by { $column }
compare-algorithm = algorithm
compare-algorithm-why = In the order of the menu
counters-why = Large: all steps so far. With +: in this step. Total: in the whole run.
compare-agrees = { $leaves } leaves, the right ones
compare-slivers = { $leaves } leaves, and { $expected } by the reference: the ray is in the others no longer than doubles tell
compare-differs = { $leaves } leaves, not those of the reference
compare-leaves = leaves
compare-leaves-why = Visited leaves; = if they are those of the reference, ≠ if not
compare-steps = steps
compare-steps-why = Steps that the trace shows
compare-nodes = touches
compare-nodes-why = Links to a child or a parent that are read
compare-tests = comp.
compare-tests-why = Comparisons of coordinates and parameters, of every kind
compare-quotients = div.
compare-quotients-why = Divisions
compare-none = Compares the algorithms once a ray is asked for.
compare-coming = All algorithms are following the ray …
compare-too-many = The tree is too large to test every leaf, to walk through its grid or to link its nodes at every movement; what would need that is left out.
timeline-name = Step of the trace
timeline-number = Number of the step
timeline-speed = Speed
timeline-wrong = Step { $step } is the first one that goes wrong
timeline-cut = The run is longer: the trace ends after so many steps
timeline-why = A tick for every step. Tall: a leaf or a result, and where the run begins and ends. Down from the line: into a node. Up from it: back to an ancestor. Yellow: the next child, cell or plane is chosen. Purple: only touched. Short: computed.
timeline-rounded = Steps with a triangle: doubles would err

tree-name = Tree view
tree-hint = Drag to move, Ctrl and the wheel to zoom; a double click shows everything.
tree-key = At a folded node: numbers of the leaves visited in it (1–5), else how many it has (85).
tree-root = Root
tree-child = Child { $child }
tree-folded = { $n ->
    [one] one leaf folded
   *[other] { $n } leaves folded
}
tree-visited = number { $n } on the ray
tree-click-step = Click: to step { $n }, the first in here
tree-shift-click = Shift and click: unfold it here
tree-click-unfold = { $n ->
    [one] Click: unfold one leaf
   *[other] Click: unfold { $n } leaves
}
tree-click-fold = Click: fold it again
why-not-none = Shows what rules out the children, in searches along a ray or for a point.
why-not-leaf = The root is a leaf: there is nothing to choose.
why-not-all = None of the children is ruled out.
sentence-begin = Press → to begin.
job-open = Opening { $name }
job-restore = Opening what was open last
job-trace = Tracing a long run
job-build = Building the tree
job-broken = The work stopped without a result. Try again; if it happens again, please report it.
job-cancel = Cancel
dialog-cancel = Cancel
dialog-close = Close
dialog-error = This did not work
notes-title = Octoscope notes
notes-blank = The window is blank, nobody sees anything. B brings it back.
notes-next = Next
notes-end = The trace ends here.
notes-restart = restart
find-theme = Theme: { $theme }
find-hint = Command, scene, algorithm or erratum
find-nothing = Nothing has this name. A scene, an algorithm, a command or an error of the paper can be found, in English or German.
find-disabled = There is nothing to do for this command now.
find-command = Command
find-panel = Panel
find-scene = Scene
find-query = Question
find-query-ray = Ray: the leaves along it
find-query-point = Point: in which leaf it lies
find-query-region = Region: the smallest node that holds it
find-query-neighbour = Neighbours of a cell
find-algorithm = Algorithm
find-erratum = Erratum
dialog-keys = Keys
dialog-about = About Octoscope
dialog-export = Export the view
dialog-export-view = What
path-open = Open: type a path
path-save = Save as: type a path
path-export = Export: type a path
path-open-hint = This system shows no file dialog. A file can be dropped on the window, too.
path-hint = This system shows no file dialog.
path-open-confirm = Open
path-save-confirm = Save
path-export-confirm = Export
path-replaces = A file of this name is there already. Replace it?
path-replace = Replace
export-exercise = Exercise
export-own-ray = this ray
export-numbered = a new one for each number
export-seed = number
export-solution = with its solution
export-moments = Moments
export-even = evenly
export-leaves = at leaves
export-listed = these steps
export-at-most = at most
export-listed-wrong = Give steps from 0 to { $last } with commas between, at most { $most }.
export-format = Format
export-extent = Page
export-cropped = around the figure
export-wide = this width
export-sized = this size
export-size = Size
export-width = Width
export-height = Height
export-enlarged = Enlargement
export-type-scale = Type and lines
export-line-scale = lines alone
export-theme = Colours
export-background = Background
export-transparent = transparent
export-steps = Steps
export-up-to-here = up to this one
export-here = this one
export-range = from … to
export-all = all
export-from = from
export-to = to
export-pause = Seconds per step
export-slides = slides (Beamer), one per step
export-snippet = only the picture, no document
export-language = Language
export-notation = Notation
export-show = What is shown
export-preview = Preview of the figure
export-preview-step = Step { $step }, one of { $first } to { $last }
export-preview-rows = The last { $shown } of { $steps } steps
export-preview-text = The text has all { $steps } steps, this picture { $first } to { $last }
export-command = The same on the command line
export-copy-command = Copy
export-unsaved = First save the scenario as { $file }.
export-file = File
export-choose = Choose…
export-nameless = Name a file.
export-new = Will be written to { $path }
export-replaces = Is there already and will be replaced: { $path }
export-folder = This is a folder; add the name of a file to it: { $path }
export-do = Export
export-copy-image = Copy as image
export-copy-svg = Copy as SVG
export-copy-table = Copy as text
theme-light = light
theme-dark = dark
theme-print = print
theme-projector = projector
job-export = Exporting { $name }
job-copy = Making the copy
status-copied-image = The figure is on the clipboard, as an image.
status-copied-svg = The figure is on the clipboard, as the text of an SVG.
status-copied-table = The table of steps is on the clipboard.
status-copied-command = The command is on the clipboard.
about-text = Octoscope shows ordered traversals of quadtrees and octrees step by step. Its subject is the seminar paper “Ray Tracing mit Octrees” by M. Kirschmann, Ulm, and the algorithms it names.
about-licence = Version { $version }, under the MIT or the Apache licence 2.0.
drop-here = Drop the file to open it
status-no-ray = This query has no ray. “Ray” under Query brings the last one back.
status-rules = Algorithm: { $algorithm }; { $rules }
status-rule-printed = rule { $rule } as printed
status-back = Ctrl+Z goes back: { $before }
status-detour = The printed rule comes to the right result by a detour, which begins here.
status-no-misprint = Every rule is followed in its right form, so no misprint leads astray. The paper lab switches misprints on.
status-only-in-space = This is for octrees: a quadtree is seen from one side only.
status-largest = In this window type can get no larger.
status-smallest = Type can get no smaller.
status-cancelled = Cancelled.
status-saving = Saving { $name } …
status-saved = Saved as { $name }
status-kept = “{ $title }” had changes that no file has: Ctrl+Z brings it back.
status-not-restored = What was open last cannot be opened now; the next start tries again. { $why }
status-still-exporting = An export or a copy is still being made. Wait for its end, or cancel it.
status-exported = Exported as { $path }
left-out-leaves = { $n } leaves beside the ray are left out; figures show at most { $most }
left-out-solids = { $n } points or solids are left out; figures show at most { $most }
left-out-right = what is right and wrong is not marked; runs to their end are checked, in trees of at most { $most } leaves
left-out-rows = the table shows the last { $shown } of { $steps } steps

paper-none = No rule of this algorithm is misprinted in the paper.
paper-counterexample = Load the counterexample
paper-too-large = The tree is too large to be checked leaf by leaf.
paper-coming = The run is being checked leaf by leaf …
paper-agrees = On this input the printed rule does no harm.
paper-longer = Comes to the right result, but by { $steps } steps instead of { $right }. The detour begins at step { $step }.
paper-longer-short = Right, but in { $steps } steps instead of { $right }, from step { $step } on.
paper-marks = Dotted: what would be right; crossed out: what is wrongly reported.
paper-marks-mirrored = Dashed is the mirrored ray as corrected and, in violet, as printed. Dotted is what would be right.
paper-wrong = Goes wrong at step { $step }.
paper-go = Go to that step
paper-other = Find another ray where they differ
paper-other-point = Find another point where they differ
paper-other-region = Find another region where they differ
paper-other-cell = Find another cell where they differ
paper-no-other = Nothing else was found on which the printed and the right rule differ; try a tree with more levels.
paper-printed = As printed
paper-right = Corrected
paper-all = All errata of “Ray Tracing mit Octrees”
paper-severity-wrong = comes to a wrong result
paper-severity-misleading = misleads the reader
paper-severity-cosmetic = a slip of the pen
paper-try = Try { $variant }
job-other = Looking for another counterexample

map-none = There is no map: it shows what becomes of many rays, but { $asked ->
    [query-point] a point is located
    [query-region] a region is located
   *[query-neighbour] a neighbour is looked for
}. Esc goes back to the ray.
map-rays-origin = From the origin
map-rays-picture = As seen
map-colouring = What the colours tell
map-sequence = Visited sequence
map-leaves = Number of visited leaves
map-steps = Steps of the algorithm
map-comparisons = Comparisons of the algorithm
map-differences = Right or wrong
map-ray = Whole ray: { $leaves ->
    [one] 1 leaf
   *[other] { $leaves } leaves
}, { $steps ->
    [one] 1 step
   *[other] { $steps } steps
}, { $comparisons ->
    [one] 1 comparison
   *[other] { $comparisons } comparisons
}
map-ray-long = Its run is too long to be counted here
map-axis-angle = Angle of the direction (°)
map-axis-offset = Distance from the centre
map-axis-turn = To the side (°)
map-axis-rise = Upwards (°)
map-extent-picture = The lines of sight of the space view
map-sequence-legend = Another colour: other leaves, or in another order
map-legend-nothing = No leaf
map-legend-right = Right
map-legend-ray = The present ray
map-legend-ray-seen = The present ray, seen from here: it is no line of sight
map-legend-ray-beyond = The present ray lies beyond the sides of the map
map-differences-legend = { $wrong ->
    [0] None of { $rays } rays goes wrong
    [one] 1 of { $rays } rays goes wrong
   *[other] { $wrong } of { $rays } rays go wrong
}
map-unknown-legend = { $rays ->
    [one] Grey: one run was given up after a million steps, right so far
   *[other] Grey: { $rays } runs were given up after a million steps, right so far
}
map-by-batch = Computed for many rays at once, exactly
map-by-batch-right = Colours: the right search, computed for many rays at once. Only the line above is the rule as printed
map-by-algorithm = Counted while the algorithm shown runs, ray by ray
map-by-both = The algorithm that is shown, compared with an exact search
map-progress = The map is being made

notation-seed = As in “Ray Tracing mit Octrees”
notation-revelles = As Revelles, Ureña and Lastra write
notation-frisken-perry = As Frisken and Perry write
notation-now = Formulas: { $notation }. { $key } goes on to the next notation.

# Other words by which something is looked for, between commas.
also-command-preset-lecture = presentation, talk, hall, slides
also-command-next-theme = colours, light, dark, print, projector
also-theme-projector = beamer, hall
also-theme-print = paper
also-command-go-to-step = jump, number
also-command-export = figure, picture, SVG, PDF, PNG, GIF, TikZ, LaTeX, slides, worksheet, storyboard
also-command-blank = black
also-command-lab = benchmark, measure, time
also-command-next-language = German, English
also-command-snap-ray = degenerate
