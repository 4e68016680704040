# Was in Dateien falsch ist, die importiert werden, auf Deutsch: zuerst die Tatsache, dann, was richtig wäre.

import-ply-type = „{ $word }“ ist kein Typ von PLY; schreiben Sie char, uchar, short, ushort, int, uint, float oder double
import-ply-property-first = Vor dem ersten Element steht eine Eigenschaft; setzen Sie ein Element davor
import-ply-no-format = Der Kopf nennt kein Format; ergänzen Sie „format ascii 1.0“ oder eines der binären Formate
import-ply-line = „{ $word }“ ist keine vollständige Zeile im Kopf von PLY; schreiben Sie format, comment, element, property oder end_header
import-ply-header-ends = Die Datei endet vor „end_header“; holen Sie sie noch einmal
import-ply-format = „{ $word }“ ist kein Format von PLY; schreiben Sie ascii, binary_little_endian oder binary_big_endian
import-ply-length-type = Die Länge einer Liste ist keine ganze Zahl; schreiben Sie uchar oder int
import-ply-property = Die Eigenschaft ist unvollständig; schreiben Sie „property TYP NAME“ oder „property list TYP TYP NAME“
import-ply-rows = „{ $word }“ ist keine Anzahl von Zeilen; schreiben Sie eine ganze Zahl von 0 an
import-ply-no-properties = Ein Element mit Zeilen hat keine Eigenschaften; geben Sie ihm welche oder 0 Zeilen
import-ply-announced = { $rows } Zeilen sind angekündigt, die mindestens { $needed } Bytes brauchen, aber { $found } folgen; holen Sie die Datei noch einmal
import-ply-no-xyz = Den Ecken fehlt eine der Eigenschaften x, y und z; ergänzen Sie sie
import-ply-not-finite = Eine Koordinate der Ecke { $number } ist nicht endlich; berichtigen Sie die Datei dort, wo sie gemacht wurde
import-ply-no-indices = Den Flächen fehlt die Liste vertex_indices; ergänzen Sie sie oder lassen Sie die Flächen weg
import-ply-missing = Die Ecke { $number } ist nicht unter den { $n }; nummerieren Sie die Ecken von 0 an und setzen Sie sie vor die Flächen
import-ply-length = { $length } Einträge kann eine Liste nicht haben; schreiben Sie eine ganze Zahl von 0 an
import-ply-ends = Die Datei endet dahinter, wo noch Zahlen stehen müssten; holen Sie sie noch einmal
import-ply-row-ends = Die Datei endet mitten in einer Zeile; holen Sie sie noch einmal
import-face = Die Fläche hat { $n } Ecken; geben Sie ihr wenigstens 3
import-obj-statement = Die Anweisung hat mehr als { $most } Wörter; teilen Sie sie
import-obj-vertex = Die Ecke hat zu wenige Koordinaten; schreiben Sie „v x y z“
import-obj-number = „{ $word }“ ist keine Nummer einer Ecke; nummerieren Sie die Ecken von 1 an oder von -1 rückwärts
import-obj-missing = Die Ecke { $number } steht nicht darüber; nummerieren Sie die Ecken von 1 an oder von -1 rückwärts
import-stl-header-ends = Die Datei endet in ihrem Kopf von { $length } Bytes; holen Sie sie noch einmal
import-stl-count = { $announced } Dreiecke sind angekündigt, { $n } folgen; holen Sie die Datei noch einmal
import-stl-not-finite = Eine Koordinate des Dreiecks { $number } ist nicht endlich; berichtigen Sie das Netz dort, wo es gemacht wurde
import-stl-vertex = Die Ecke hat zu wenige Koordinaten; schreiben Sie „vertex x y z“
import-stl-long = Die Schleife hat mehr als 3 Ecken; geben Sie ihr 3
import-stl-loop = Die Schleife hat { $n } Ecken; geben Sie ihr 3
import-stl-keyword = „{ $word }“ ist kein Wort von STL; schreiben Sie solid, facet, outer, vertex, endloop, endfacet oder endsolid
import-stl-ends = Die Datei endet vor „endsolid“; holen Sie sie noch einmal
import-no-number = Hier fehlt eine Zahl; schreiben Sie eine wie -1.25 oder 3e-4
import-not-a-number = „{ $word }“ ist keine Zahl; schreiben Sie eine wie -1.25 oder 3e-4
import-not-finite = „{ $word }“ ist keine endliche Zahl; schreiben Sie eine unter 1e308
import-columns = Die Zeile hat { $n ->
    [one] { $n } Spalte
   *[other] { $n } Spalten
}, die erste hat { $first }; geben Sie jeder Zeile dieselben Spalten
import-one-column = Die Zeile hat eine Spalte; schreiben Sie zwei oder drei Koordinaten je Zeile
import-many-columns = Die Zeile hat mehr als { $most } Spalten; schreiben Sie einen Punkt je Zeile
import-few-numbers = Die Zeile hat { $n } von { $due } Zahlen; ergänzen Sie, was fehlt
import-many-numbers = Die Zeile hat mehr als { $due } Zahlen; nehmen Sie den Rest weg oder schreiben Sie # davor
import-cell = „{ $word }“ ist keine ganze Zahl in 0 … { $most }; schreiben Sie Zellen des Gitters oder verlangen Sie eine größere Tiefe
import-zero-direction = Die Richtung ist null; geben Sie wenigstens einer Komponente einen anderen Wert
