# Texte des Messlabors, auf Deutsch.

lab-name-batch = Bündel, Vektoren
lab-name-batch-plain = Bündel, einfach
lab-quantity-time = Zeit je Strahl
lab-quantity-time-per-leaf = Zeit je Blatt
lab-quantity-steps = Schritte je Strahl
lab-quantity-node-touches = Zugriffe
lab-quantity-comparisons = Vergleiche
lab-quantity-lines = Speicherzeilen
lab-quantity-cache-misses = Nicht im Cache
lab-quantity-branch-misses = Falsche Vorhersagen
lab-quantity-cells = Zellen je Achse
lab-quantity-tree-leaves = Blätter des Baums
lab-quantity-ray-leaves = Blätter am Strahl
lab-unit-time = µs je Strahl
lab-unit-time-per-leaf = ns je Blatt
lab-unit-steps = Schritte je Strahl
lab-unit-node-touches = Zugriffe je Strahl
lab-unit-comparisons = Vergleiche je Strahl
lab-unit-lines = Zeilen zu 64 Byte je Strahl
lab-unit-cache-misses = Lesezugriffe je Strahl nicht in 32 KiB Cache
lab-unit-branch-misses = falsche Vorhersagen je Strahl
lab-unit-cells = Zellen je Achse (2 hoch Tiefe)
lab-unit-tree-leaves = Blätter des Baums
lab-unit-ray-leaves = Blätter am Strahl
lab-best = bester { $value }
lab-scenes-note = Tiefe { $depth }. Jeder Balken als Vielfaches des besten, dessen Wert rechts der Szene steht ({ $unit }); die Skala ist logarithmisch.
lab-growth-note = { $scene }. Hinter jedem Namen steht e: Der Aufwand wächst wie die Größe hoch e (mit kleinsten Quadraten an die Logarithmen angepasst).
lab-measured-once = { " " }Nur einmal gemessen: vor einem Vergleich der Zeiten wiederholen.
lab-side-by-side = { " " }Kurven, die sich decken, sind nebeneinander gezeichnet.
lab-nothing = Es ist noch nichts gemessen: links auswählen und „Messen“ drücken.
lab-no-site = { $scene } wurde in Tiefe { $depth } nicht gemessen.
lab-uncounted = Diese Zahl gibt es hier nicht.
lab-no-algorithm = Ein Verfahren wählen, um ihm auf dem Strahl zuzusehen.
lab-one-depth = Wie der Aufwand wächst, zeigen erst Messungen in zwei oder mehr Tiefen.
lab-statement = Aussage
lab-published = veröffentlicht
lab-here = hier
lab-nodes = Zugriffe
lab-comparisons = Vergleiche
lab-holds = gilt hier
lab-about-one = etwa 1
lab-holds-agrees = ja
lab-holds-same-side = nur die Reihenfolge
lab-holds-differs = nein
lab-holds-not-measured = nicht gemessen
lab-published-note = So sind die Zahlen zu lesen: Zeit des ersten Verfahrens geteilt durch die des zweiten, als geometrisches Mittel über die Szenen der Aussage und alle gemessenen Tiefen. Zugriffe und Vergleiche sind ebenso geteilt.
lab-verdict-none = Keine der veröffentlichten Aussagen betrifft, was gemessen wurde.
lab-verdict =
    { $measured ->
        [one] Eine veröffentlichte Aussage wurde nachgemessen
       *[other] { $measured } veröffentlichte Aussagen wurden nachgemessen
    }: { $agrees ->
        [0] Keine gilt hier
        [one] Eine gilt hier
       *[other] { $agrees } gelten hier
    }{ $side ->
        [0] { "" }
        [one] , eine nur darin, welches Verfahren schneller ist
       *[other] , { $side } nur darin, welches Verfahren schneller ist
    }{ $differs ->
        [0] { "" }
        [one] , eine gilt nicht
       *[other] , { $differs } gelten nicht
    }.
lab-why-agrees = „{ $of }“ braucht { $here }-mal so lange wie „{ $against }“{ $place }; veröffentlicht ist der Faktor { $published }.
lab-why-same-side = „{ $of }“ braucht { $here }-mal so lange wie „{ $against }“{ $place }; veröffentlicht ist der Faktor { $published }. Schneller ist also dasselbe Verfahren, aber um einen anderen Faktor: Es greift { $nodes }-mal so oft auf Knoten zu und vergleicht { $comparisons }-mal so oft.
lab-why-differs = „{ $of }“ braucht { $here }-mal so lange wie „{ $against }“{ $place }; veröffentlicht ist der Faktor { $published }. Es greift { $nodes }-mal so oft auf Knoten zu und vergleicht { $comparisons }-mal so oft; was das kostet, hängt von Prozessor, Compiler und der Lage des Baums im Speicher ab.
lab-sources = Nach Revelles, Ureña und Lastra (2000) ist das parametrische Verfahren etwa so schnell wie das von Gargantini und der Octree um 10.4, 12.7 und 6.8 % schneller als der BSP-Baum. Nach Havran (1999) ist Samets Verfahren schneller als das von Gargantini, im geometrischen Mittel von neun anderen Szenen. Von all diesen Szenen sind nur Größe und Art bekannt; unsere entstehen aus einem Startwert.
lab-memory = Lesezugriffe auf den Speicher
lab-branches = Entscheidungen
lab-reads = { $n } Lesezugriffe auf { $lines } Zeilen zu 64 Byte
lab-guesses = { $n } Entscheidungen, { $wrong } falsch vorhergesagt
lab-cut = (nur der Anfang)
lab-processor-note = So folgte ein Prozessor dem gezeigten Strahl, ein Strich für jeden Lesezugriff und jede Entscheidung in ihrer Reihenfolge. Sein Cache ist anfangs leer, seine Sprungvorhersage weiß noch nichts. Speicher wird in Zeilen zu 64 Byte geholt; eine falsche Vorhersage kostet etwa 15 Takte. Entscheidungen sind die Stellen, an denen ein Programm verzweigt: Anders als bei den Vergleichen der Zähler sind die Blattprüfungen dabei, und die Prüfung eines ganzen Quaders ist eine.
lab-kinds = Falsch vorhergesagt, von allen Entscheidungen, nach dem, was gefragt wird
lab-kind-leaf = ein Blatt?
lab-kind-entry = Eintritt
lab-kind-exit = Austritt
lab-kind-range = im Bereich?
lab-kind-sort = Reihenfolge
lab-kind-climb = weiter hinauf?
lab-title = Messlabor
lab-tab-scenes = Szenen
lab-tab-growth = Wachstum
lab-tab-published = Veröffentlicht
lab-tab-table = Tabelle
lab-tab-processor = Speicher und Vorhersage
lab-scenes = Szenen
lab-algorithms = Verfahren
lab-depths = Tiefen
lab-to = bis
lab-least-depth = Kleinste Tiefe
lab-most-depth = Größte Tiefe
lab-rays = Strahlen
lab-repeats = Wiederholungen
lab-seed = Startwert
lab-run = Messen
lab-running = Es wird gemessen
lab-stop = Anhalten
lab-all = alle
lab-none = keine
lab-paper = die des Aufsatzes
lab-nothing-chosen = Eine Szene und ein Verfahren wählen.
lab-disagrees = In { $scene } in Tiefe { $depth } findet { $method } andere Blätter als { $reference }, zuerst an Strahl { $ray }.
lab-agree = Alle Verfahren haben dieselben Blätter gefunden.
lab-unoptimised = Dieses Programm ist ohne Optimierung übersetzt: Seine Zeiten sagen nichts, seine Zählungen schon.
lab-not-built = Ausgelassen, weil ihr Baum nicht gebaut werden kann (Szene und Tiefe): { $names }
lab-stopped = Angehalten; gezeigt wird, was bis dahin gemessen war.
lab-quantity = Gezeigt
lab-against = gegen
lab-scene = Szene
lab-depth = Tiefe
lab-save = Speichern als
lab-chart-svg = Diagramm als SVG
lab-chart-pdf = Diagramm als PDF
lab-chart-png = Diagramm als PNG
lab-chart-tex = Diagramm als TikZ
lab-table-csv = Tabelle als CSV
lab-table-md = Tabelle als Markdown
lab-left-out = Ausgelassen, weil der Baum zu groß ist: { $names }
lab-site = { $scene }, Tiefe { $depth }: { $leaves } Blätter, { $rays } Strahlen
lab-cached = im Cache
lab-uncached = aus dem Hauptspeicher
lab-predicted = richtig vorhergesagt
lab-mispredicted = falsch vorhergesagt
lab-depth-n = Tiefe { $depth }
lab-algorithm = Verfahren
lab-times = Zeit
lab-computed = Zugriffe, Vergleiche und Divisionen
lab-way = Weg durch den Baum, und was er den Prozessor kostet
lab-table-note = Mittel je Strahl; vom Stapel die größte Tiefe. Zeilen sind solche zu 64 Byte im Speicher. ± % ist der halbe Abstand der Quartile aller Wiederholungen; eine einzige hat keinen.
lab-column-time = µs/Strahl
lab-column-spread = ± %
lab-column-time-per-leaf = ns/Blatt
lab-column-rate = Strahlen/s
lab-column-of-best = × bester
lab-column-codes = Codes
lab-column-divisions = Divisionen
lab-column-locations = geortet
lab-column-up = hinauf
lab-column-down = hinab
lab-column-stack = Stapel
lab-column-lines = Zeilen
lab-column-uncached = nicht im Cache
lab-column-misguessed = falsch vorhergesagt
