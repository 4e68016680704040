# What can go wrong with files, in English: the fact first, then what to do.

error-not-found = There is no such file or folder
error-denied = Permission denied; allow it, or choose another
error-full = There is no room left; make some, or write elsewhere
error-folder = This is a folder, not a file; choose a file
error-folder-as-file = This is a folder; name a file
error-file-as-folder = This is a file, so nothing can be written inside it; name a folder
error-no-folder = There is no such folder to write to; create it first, or name another
error-no-file-here = No file can be made in this folder; name another folder
error-read-only = This file is read-only; allow writing it, or name another
error-name-too-long = The name is too long; choose a shorter one
error-too-long = The { $kind ->
    [device] device
    [pipe] pipe
   *[file] file
} holds more than { $limit }; reduce it first
error-no-memory = There is not memory enough for this file; reduce it first
error-nobody-writes = Nobody writes into this pipe; start who does, or name a file
error-no-text = Byte { $byte } is no text; save the file as text in UTF-8
error-utf-16 = The text is in UTF-16; save it in UTF-8
error-line = line { $line }, column { $column }
error-byte = byte { $byte }

error-empty = The file is empty; choose one that holds a picture, a mesh or points
error-unknown-kind = Files of this kind cannot be opened; choose a scenario that ends in .octo, a file that ends in .png, .jpg, .obj, .stl, .ply, .xyz or .csv, or an exported figure that ends in .svg, .pdf, .png or .tex
error-list-of-cells = A list of cells has no depth; write the cells into a scenario (.octo) as "cells" in its "scene", with a "depth" in its "build", or send rays through them by octoscope visit --cells FILE --depth N --rays FILE
error-list-of-rays = A list of rays has no tree; send the rays through one by octoscope visit --cells FILE --depth N --rays FILE, or write one of them into a scenario (.octo) as "ray"
error-no-scenario = There is no scenario inside the figure; choose one that Octoscope has exported
error-wrong-content = The name says { $expected }, but the file holds { $found }; give it the ending of what it holds
error-malformed = The file is damaged or not what its name says, { $place }: { $details }
error-picture = The picture is damaged: { $reason }; save it again as PNG or JPEG
error-picture-ends = The picture is damaged: it ends too early; save it again as PNG or JPEG
error-picture-given-up = The picture is damaged: it cannot be read; save it again as PNG or JPEG
error-too-large = The file holds { $found } { $what }, more than { $limit }; reduce it first
error-points = points
error-triangles = triangles
error-pixels = pixels
error-no-points = The file holds no points; choose one with at least one point or triangle

error-scenario = { $details }
error-scenario-no-object = this is no scenario; write an object such as { $least }
error-scenario-no-version = there is no version 0 of the format; write { $version }
error-scenario-dimension = the dimension is { $given }; give 2 for a quadtree or 3 for an octree
error-scenario-no-dimension = the field “dimension” is missing; give 2 for a quadtree or 3 for an octree
error-scenario-kinds = the scene has { $count } kinds of content; give exactly one of built-in, points, cells, image, spheres, boxes, triangles and file
error-scenario-stray = the scene’s field “{ $field }” goes only with “{ $with }”; leave it out
error-scenario-row = row { $row } of the picture, counted from 1, does not fit; give as many rows as “height” says, and in each as many colours of 2 or 6 hexadecimal digits as “width” says
error-scenario-no-pixels = the picture has no pixels; give a “width” and a “height” of 1 or more
error-scenario-level = { $given } is above { $most }, the number of bits of codes; give a number from 0 to { $most }
error-scenario-capacity = the capacity is 0; give 1 or more
error-scenario-ray-not-finite = a coordinate of the ray is not a finite number; give finite decimal numbers
error-scenario-ray-zero = the direction of the ray is zero; give at least one component another value
error-scenario-direction = this leads to no neighbour; give −1, 0 or 1 for each axis, not 0 for all
error-scenario-domain = the domain needs finite corners and a side above 0; give it those
error-scenario-unusable = this item has a negative size or turned corners; give a radius from 0, and no corner “min” above “max”
error-scenario-unknown = there is no built-in scene “{ $name }”; there are { $known }
error-scenario-other-dimension = the built-in scene “{ $name }” has { $has } dimensions, not { $asked }; give these, or leave them out
error-scenario-no-parameter = the built-in scene “{ $name }” has no parameter “{ $parameter }”; leave it out
error-scenario-range = parameter “n” of the built-in scene “{ $name }” is { $n }; give a number from 1 to { $most }
error-newer = the scenario has version { $version }, which this program does not read yet; use a newer program
error-scenario-too-large = The scenario is larger than 256 MiB; keep its data in a file of its own
error-data-file = The scenario’s data file cannot be read; put it where “file” says
error-other-data = The data file is not the one the scenario was made with; restore it, or delete “hash” from the scenario
error-other-dimension = The data file has another dimension than the scenario
error-too-many-nodes = The tree would have more than { $most } nodes; use a smaller depth
error-outside = { $count } of the items lie outside the domain, the first of them is number { $first } (counted from 0); enlarge or move the domain, or leave them out
error-unusable = Item number { $item } (counted from 0) has a coordinate that is not finite, a negative size or corners in the wrong order; mend it or leave it out
error-too-fine = Cells of this size cannot be told apart so far from 0; use fewer levels or move the domain
error-image-in-space = A picture lies in the plane; give the scene two dimensions
error-no-step = There is no step { $step }; choose one from 0 to { $last }
error-steps-backwards = The steps { $first } to { $last } run backwards; name the smaller one first
error-too-many-steps = These are { $n } steps, and a file holds at most { $most }; choose some of them, such as { $first } to { $last }
error-building = The tree cannot be built: { $details }
error-view-query = The view “{ $view }” has nothing to show of what is asked; choose another one
error-view-step = The view “{ $view }” has nothing to show after step { $step }; it has after step { $first }
error-view-never = The view “{ $view }” has nothing to show in any step of this run; try another algorithm or ray
error-exercise-missed = The ray misses the tree; take another one, or a new one for each number
error-exercise-long = The ray enters { $n } inner nodes, more than a worksheet has room for; take a tree of 2 to 4 levels or a shorter ray, or a new one for each number
error-exercise-none = No ray through this tree can be followed by hand with profit; take a tree of 2 to 4 levels
error-kept = The field “{ $field }” of the scenario’s “view” cannot be read: { $details }
error-kept-no-names = it is no text; write names between commas
error-kept-no-numbers = it is no text; write “-30,20,1.5”
error-kept-middle = its middle has { $n } numbers; give { $dimension }, or none
error-shown-part = there is no “{ $given }” to show; there are { $known }, and none
error-shown-setting = there is no “{ $given }” to set; there are levels, rest, slice and apart
error-shown-levels = there are no levels “{ $given }”; give two as in levels=2-5
error-shown-rest = the rest cannot be “{ $given }”; it can be { $known }
error-shown-slice = there is no slice at “{ $given }”; give axis and share, as in slice=x:0.5
error-shown-apart = children cannot be apart by “{ $given }”; give sides from 0 to { $known }
error-eye-no-numbers = give numbers such as -30,20,1.5
error-eye-count = there are { $n } numbers; give three: yaw and pitch in degrees, zoom; and then, if you like, the point in the middle, and the word parallel
error-eye-pitch = the pitch is { $given }; give degrees from -90 to 90
error-eye-zoom = the zoom is { $given }; give a factor from 0.001 to 1000000
