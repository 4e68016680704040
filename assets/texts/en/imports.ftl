# What is wrong inside files that are imported, in English: the fact first, then what would be right.

import-ply-type = “{ $word }” is no type of PLY; write char, uchar, short, ushort, int, uint, float or double
import-ply-property-first = a property precedes the first element; put an element before it
import-ply-no-format = the header names no format; add “format ascii 1.0” or one of the binary formats
import-ply-line = “{ $word }” is no complete line of a PLY header; write format, comment, element, property or end_header
import-ply-header-ends = the file ends before “end_header”; fetch the file again
import-ply-format = “{ $word }” is no format of PLY; write ascii, binary_little_endian or binary_big_endian
import-ply-length-type = the length of a list is not a whole number; write uchar or int
import-ply-property = the property is incomplete; write “property TYPE NAME” or “property list TYPE TYPE NAME”
import-ply-rows = “{ $word }” is not a number of rows; write a whole number from 0
import-ply-no-properties = an element with rows has no properties; give it properties or 0 rows
import-ply-announced = { $rows } rows are announced, which take { $needed } bytes or more, but { $found } follow; fetch the file again
import-ply-no-xyz = the vertices lack one of the properties x, y and z; add what is missing
import-ply-not-finite = a coordinate of vertex { $number } is not finite; repair the file where it was made
import-ply-no-indices = the faces lack the list vertex_indices; add it, or leave the faces out
import-ply-missing = vertex { $number } is not among the { $n }; number the vertices from 0 and put them before the faces
import-ply-length = a list cannot have { $length } items; write a whole number from 0
import-ply-ends = the file ends behind this, where more numbers are due; fetch the file again
import-ply-row-ends = the file ends within a row; fetch the file again
import-face = the face has { $n } corners; give it at least 3
import-obj-statement = the statement has more than { $most } words; split it
import-obj-vertex = the vertex has too few coordinates; write “v x y z”
import-obj-number = “{ $word }” is not a vertex number; number the vertices from 1, or from -1 backwards
import-obj-missing = vertex { $number } is not defined above; number the vertices from 1, or from -1 backwards
import-stl-header-ends = the file ends within its header of { $length } bytes; fetch the file again
import-stl-count = { $announced } triangles are announced, { $n } follow; fetch the file again
import-stl-not-finite = a coordinate of triangle { $number } is not finite; repair the mesh where it was made
import-stl-vertex = the vertex has too few coordinates; write “vertex x y z”
import-stl-long = the loop has more than 3 vertices; give it 3
import-stl-loop = the loop has { $n } vertices; give it 3
import-stl-keyword = “{ $word }” is no STL keyword; write solid, facet, outer, vertex, endloop, endfacet or endsolid
import-stl-ends = the file ends before “endsolid”; fetch the file again
import-no-number = a number is missing; write a number such as -1.25 or 3e-4
import-not-a-number = “{ $word }” is not a number; write a number such as -1.25 or 3e-4
import-not-finite = “{ $word }” is not a finite number; write a number below 1e308
import-columns = the line has { $n ->
    [one] { $n } column
   *[other] { $n } columns
}, the first has { $first }; give every line the same columns
import-one-column = the line has one column; write two or three coordinates a line
import-many-columns = the line has more than { $most } columns; write one point a line
import-few-numbers = the line has { $n } of { $due } numbers; add what is missing
import-many-numbers = the line has more than { $due } numbers; take the rest away, or write # before it
import-cell = “{ $word }” is not a whole number in 0 … { $most }; write cells of the grid, or ask for a greater depth
import-zero-direction = the direction is zero; give at least one of its components another value
