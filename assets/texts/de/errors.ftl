# Was mit Dateien schiefgehen kann, auf Deutsch: zuerst die Tatsache, dann, was zu tun ist.

error-not-found = Es gibt keine solche Datei und keinen solchen Ordner
error-denied = Der Zugriff ist nicht erlaubt; erlauben Sie ihn oder wählen Sie etwas anderes
error-full = Es ist kein Platz mehr; schaffen Sie welchen oder schreiben Sie anderswohin
error-folder = Das ist ein Ordner, keine Datei; wählen Sie eine Datei
error-folder-as-file = Das ist ein Ordner; nennen Sie eine Datei
error-file-as-folder = Das ist eine Datei, in die nichts hineingeschrieben werden kann; nennen Sie einen Ordner
error-no-folder = Den Ordner dafür gibt es nicht; legen Sie ihn an oder nennen Sie einen anderen
error-no-file-here = In diesem Ordner kann keine Datei angelegt werden; nennen Sie einen anderen
error-read-only = Diese Datei ist schreibgeschützt; erlauben Sie das Schreiben oder nennen Sie eine andere
error-name-too-long = Der Name ist zu lang; wählen Sie einen kürzeren
error-too-long = { $kind ->
    [device] Das Gerät
    [pipe] Die Pipe
   *[file] Die Datei
} enthält mehr als { $limit }; verkleinern Sie den Inhalt
error-no-memory = Für diese Datei reicht der Speicher nicht; verkleinern Sie sie
error-nobody-writes = In diese Pipe schreibt niemand; starten Sie, wer es tun soll, oder nennen Sie eine Datei
error-no-text = Byte { $byte } ist kein Text; speichern Sie die Datei als Text in UTF-8
error-utf-16 = Der Text ist in UTF-16; speichern Sie ihn in UTF-8
error-line = Zeile { $line }, Spalte { $column }
error-byte = Byte { $byte }

error-empty = Die Datei ist leer; wählen Sie eine, die ein Bild, ein Netz oder Punkte enthält
error-unknown-kind = Dateien dieser Art lassen sich nicht öffnen; wählen Sie ein Szenario, das auf .octo endet, eine Datei, die auf .png, .jpg, .obj, .stl, .ply, .xyz oder .csv endet, oder eine exportierte Abbildung, die auf .svg, .pdf, .png oder .tex endet
error-list-of-cells = Eine Liste von Zellen hat keine Tiefe; schreiben Sie die Zellen in ein Szenario (.octo), als "cells" in "scene", mit einer "depth" in "build", oder schicken Sie Strahlen hindurch mit octoscope visit --cells DATEI --depth N --rays DATEI
error-list-of-rays = Eine Liste von Strahlen hat keinen Baum; schicken Sie die Strahlen durch einen mit octoscope visit --cells DATEI --depth N --rays DATEI, oder schreiben Sie einen davon als "ray" in ein Szenario (.octo)
error-no-scenario = In der Abbildung ist kein Szenario; wählen Sie eine, die Octoscope exportiert hat
error-wrong-content = Der Name sagt { $expected }, darin ist aber { $found }; geben Sie der Datei die Endung dessen, was sie enthält
error-malformed = Die Datei ist beschädigt oder nicht das, was ihr Name sagt, { $place }: { $details }
error-picture = Das Bild ist beschädigt; speichern Sie es noch einmal als PNG oder JPEG (auf Englisch: { $reason })
error-picture-ends = Das Bild ist beschädigt: Es endet zu früh; speichern Sie es noch einmal als PNG oder JPEG
error-picture-given-up = Das Bild ist beschädigt: Es lässt sich nicht lesen; speichern Sie es noch einmal als PNG oder JPEG
error-too-large = Die Datei enthält { $found } { $what }, mehr als { $limit }; verkleinern Sie sie
error-points = Punkte
error-triangles = Dreiecke
error-pixels = Pixel
error-no-points = Die Datei enthält keine Punkte; wählen Sie eine mit wenigstens einem Punkt oder Dreieck

error-scenario = Hier ist das Szenario nicht zu verstehen (auf Englisch: { $details })
error-scenario-no-object = Das ist kein Szenario; schreiben Sie ein Objekt wie { $least }
error-scenario-no-version = Eine Fassung 0 des Formats gibt es nicht; schreiben Sie { $version }
error-scenario-dimension = Die Dimension ist { $given }; geben Sie 2 für einen Quadtree oder 3 für einen Octree an
error-scenario-no-dimension = Das Feld „dimension“ fehlt; geben Sie 2 für einen Quadtree oder 3 für einen Octree an
error-scenario-kinds = Die Szene hat { $count } Arten von Inhalt; geben Sie genau eine von built-in, points, cells, image, spheres, boxes, triangles und file an
error-scenario-stray = Das Feld „{ $field }“ der Szene gehört nur zu „{ $with }“; lassen Sie es weg
error-scenario-row = Zeile { $row } des Bilds, von 1 gezählt, passt nicht; geben Sie so viele Zeilen an, wie „height“ sagt, und in jeder so viele Farben aus 2 oder 6 Hexadezimalziffern, wie „width“ sagt
error-scenario-no-pixels = Das Bild hat keine Pixel; geben Sie „width“ und „height“ von 1 an
error-scenario-level = { $given } ist mehr als { $most }, die Zahl der Bits eines Codes; geben Sie eine Zahl von 0 bis { $most } an
error-scenario-capacity = Die Kapazität ist 0; geben Sie 1 oder mehr an
error-scenario-ray-not-finite = Eine Koordinate des Strahls ist keine endliche Zahl; geben Sie endliche Dezimalzahlen an
error-scenario-ray-zero = Die Richtung des Strahls ist null; geben Sie wenigstens einer Komponente einen anderen Wert
error-scenario-direction = Das führt zu keinem Nachbarn; geben Sie je Achse −1, 0 oder 1 an, nicht überall 0
error-scenario-domain = Das Gebiet braucht endliche Ecken und eine Seite über 0; geben Sie solche an
error-scenario-unusable = Dieser Gegenstand hat eine negative Größe oder vertauschte Ecken; geben Sie einen Radius von 0 an und keine Ecke „min“ über „max“
error-scenario-unknown = Eine eingebaute Szene „{ $name }“ gibt es nicht; es gibt { $known }
error-scenario-other-dimension = Die eingebaute Szene „{ $name }“ hat { $has } Dimensionen, nicht { $asked }; geben Sie diese an oder lassen Sie sie weg
error-scenario-no-parameter = Die eingebaute Szene „{ $name }“ hat keinen Parameter „{ $parameter }“; lassen Sie ihn weg
error-scenario-range = Der Parameter „n“ der eingebauten Szene „{ $name }“ ist { $n }; geben Sie eine Zahl von 1 bis { $most } an
error-newer = Das Szenario hat die Fassung { $version }, die dieses Programm noch nicht liest; nehmen Sie ein neueres
error-scenario-too-large = Das Szenario ist größer als 256 MiB; legen Sie seine Daten in eine eigene Datei
error-data-file = Die Datendatei des Szenarios lässt sich nicht lesen; legen Sie sie dorthin, wo „file“ sagt
error-other-data = Die Datendatei ist nicht die, mit der das Szenario gemacht wurde; stellen Sie sie wieder her oder streichen Sie „hash“ aus dem Szenario
error-other-dimension = Die Datendatei hat eine andere Dimension als das Szenario
error-too-many-nodes = Der Baum hätte mehr als { $most } Knoten; wählen Sie eine kleinere Tiefe
error-outside = { $count } der Gegenstände liegen außerhalb des Gebiets, der erste davon ist Nummer { $first } (von 0 gezählt); vergrößern oder verschieben Sie das Gebiet, oder lassen Sie sie weg
error-unusable = Gegenstand Nummer { $item } (von 0 gezählt) hat eine Koordinate, die nicht endlich ist, eine negative Größe oder Ecken in falscher Reihenfolge; berichtigen Sie ihn oder lassen Sie ihn weg
error-too-fine = So weit von 0 sind Zellen dieser Größe nicht mehr zu unterscheiden; wählen Sie weniger Stufen oder verschieben Sie das Gebiet
error-image-in-space = Ein Bild liegt in der Ebene; geben Sie der Szene zwei Dimensionen
error-no-step = Einen Schritt { $step } gibt es nicht; wählen Sie einen von 0 bis { $last }
error-steps-backwards = Die Schritte { $first } bis { $last } laufen rückwärts; nennen Sie den kleineren zuerst
error-too-many-steps = Das sind { $n } Schritte, eine Datei fasst aber höchstens { $most }; wählen Sie einige davon, etwa { $first } bis { $last }
error-building = Der Baum lässt sich nicht bauen (auf Englisch: { $details })
error-view-query = Die Ansicht „{ $view }“ hat zu dieser Frage nichts zu zeigen; wählen Sie eine andere
error-view-step = Die Ansicht „{ $view }“ hat nach Schritt { $step } nichts zu zeigen, aber nach Schritt { $first }
error-view-never = Die Ansicht „{ $view }“ hat in keinem Schritt dieses Laufs etwas zu zeigen; versuchen Sie ein anderes Verfahren oder einen anderen Strahl
error-exercise-missed = Der Strahl verfehlt den Baum; nehmen Sie einen anderen oder einen neuen für jede Nummer
error-exercise-long = Der Strahl betritt { $n } innere Knoten, mehr als auf ein Aufgabenblatt passen; nehmen Sie einen Baum mit 2 bis 4 Stufen, einen kürzeren Strahl oder einen neuen für jede Nummer
error-exercise-none = Keinem Strahl durch diesen Baum lässt sich mit Gewinn von Hand folgen; nehmen Sie einen Baum mit 2 bis 4 Stufen
error-kept = Das Feld „{ $field }“ in „view“ des Szenarios lässt sich nicht lesen: { $details }
error-kept-no-names = es ist kein Text; schreiben Sie Namen zwischen Kommas
error-kept-no-numbers = es ist kein Text; schreiben Sie „-30,20,1.5“
error-kept-middle = seine Mitte hat { $n } Zahlen; geben Sie { $dimension } an oder keine
error-shown-part = „{ $given }“ gibt es nicht zu zeigen; es gibt { $known } und none
error-shown-setting = „{ $given }“ gibt es nicht einzustellen; es gibt levels, rest, slice und apart
error-shown-levels = Stufen „{ $given }“ gibt es nicht; geben Sie zwei an wie in levels=2-5
error-shown-rest = der Rest kann nicht „{ $given }“ sein; er kann { $known } sein
error-shown-slice = einen Schnitt bei „{ $given }“ gibt es nicht; geben Sie Achse und Anteil an wie in slice=x:0.5
error-shown-apart = Kinder können nicht um „{ $given }“ auseinander sein; geben Sie 0 bis { $known } Seiten an
error-eye-no-numbers = schreiben Sie Zahlen wie -30,20,1.5
error-eye-count = es sind { $n } Zahlen; geben Sie drei an: Drehung und Höhe in Grad, Vergrößerung; danach, wenn Sie wollen, den Punkt in der Mitte und das Wort parallel
error-eye-pitch = die Höhe ist { $given }; geben Sie Grad von -90 bis 90 an
error-eye-zoom = die Vergrößerung ist { $given }; geben Sie einen Faktor von 0.001 bis 1000000 an
