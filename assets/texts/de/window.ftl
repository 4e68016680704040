# Texte des Fensters, auf Deutsch.

menu-all = Menü
menu-file = Datei
menu-edit = Bearbeiten
menu-view = Ansicht
menu-panels = Tafeln
menu-show = Bild
menu-ray = Strahl
menu-gallery = Galerie entarteter Strahlen
menu-step = Schritt
menu-help = Hilfe

command-open = Öffnen …
command-save = Speichern
command-save-as = Speichern unter …
command-export = Ansicht exportieren …
command-quit = Beenden
command-undo = Rückgängig
command-redo = Wiederholen
command-preset-bits = Geometrie und Bits
command-preset-rail = Geometrie und t-Leiste
command-preset-automaton = Geometrie und Automat
command-preset-debug = Fehlersuche
command-preset-compare = Verfahren vergleichen
command-preset-lecture = Vorlesung
command-question = Szene, Strahl und Anfrage
command-preset-tree = Geometrie und Baum
command-preset-map = Geometrie und Strahlenkarte
command-restore-panels = Anordnung zurücksetzen
command-frame-all = Alles zeigen
command-stand-node = Zum aktuellen Knoten
command-stand-right = Ansicht von rechts, längs x
command-stand-front = Ansicht von vorn, längs y
command-stand-above = Ansicht von oben, längs z
command-next-lens = Perspektive oder Parallelprojektion
command-reduced-motion = Weniger Bewegung
command-show-order-numbers = Nummern der Reihenfolge zeigen
command-show-content = Inhalt zeigen
command-show-empty-leaves = Leere Blätter zeigen
command-show-inner-nodes = Innere Knoten zeigen, nicht nur Blätter
command-show-ancestors = Vorfahren zeigen
command-show-children = Kinder zeigen
command-show-mirrored-ray = Gespiegelten Strahl zeigen
command-show-half-open-sides = Halboffene Seiten zeigen
command-show-codes = Ortscodes auf Zellen zeigen
command-show-apart = Kinder auseinanderrücken
command-next-rest = Zellen abseits des Wegs: normal, blass oder verborgen
command-fewer-small = Die kleinsten Zellen weglassen
command-more-small = Kleinere Zellen zeigen
command-fewer-large = Die größten Zellen weglassen
command-more-large = Größere Zellen zeigen
command-all-levels = Zellen aller Stufen zeigen
command-next-slice = Octree aufschneiden: gar nicht, quer zu x, y oder z
command-slice-down = Schnitt auf seiner Achse abwärts schieben
command-slice-up = Schnitt auf seiner Achse aufwärts schieben
command-follow = Aktuellem Knoten folgen
command-formulas = Formeln zeigen
command-next-notation = Nächste Schreibweise der Formeln
command-next-theme = Nächstes Farbschema
command-next-language = English
command-scale-up = Größer
command-scale-down = Kleiner
command-scale-reset = Normale Größe
command-full-screen = Vollbild
command-blank = Bildschirm leeren
command-reverse-ray = Strahl umkehren
command-snap-ray = Den Strahl entarten lassen
command-next-degenerate = Nächster Strahl der Galerie
command-back-to-ray = Zurück zum Strahl
command-step-forward = Schritt vor
command-step-back = Schritt zurück
command-next-leaf = Zum nächsten Blatt
command-previous-leaf = Zum vorigen Blatt
command-first = Zum Anfang
command-go-to-step = Zu Schritt …
command-first-wrong = Zum ersten falschen Schritt
command-last = Zum Ende
command-play = Abspielen oder anhalten
command-faster = Schneller abspielen
command-slower = Langsamer abspielen
command-spotlight = Lichtkegel
command-notes = Notizen für den zweiten Bildschirm
command-lab = Messlabor …
command-find = Befehl suchen …
command-keys = Tasten
command-about = Über Octoscope

key-ctrl = Strg
key-shift = Umschalt
key-page-up = Bild ↑
key-page-down = Bild ↓
key-home = Pos1
key-end = Ende
key-space = Leertaste

panel-scene = Szene
panel-ray = Strahl
panel-query = Anfrage
panel-show = Zeigen
panel-codes = Ortscodes
panel-region = Bereich durch XOR
panel-neighbour = Nachbar
panel-t-rail = t-Leiste
panel-automaton = Automat
panel-listing = Programm
panel-variables = Variablen
panel-stack = Stapel
panel-counters = Zähler
panel-paper = Werkstatt zum Aufsatz
panel-tables = Nachbartabellen
panel-compare = Vergleich
panel-tree = Baum
panel-why-not = Warum nicht?
panel-map = Strahlenkarte
panel-menu = Tafel { $title }
panel-fold = Einklappen
panel-unfold = Ausklappen
panel-up = Nach oben
panel-down = Nach unten
panel-close = Schließen
space-name = Raumansicht
space-click-neighbour = Klick: der Nachbar jenseits
space-ray-away = So weit ist der Ursprung des Strahls von der Wurzel entfernt: er liegt außerhalb des Bilds

scene-source = Woraus der Baum gebaut ist
scene-inline = eigene Daten
scene-depth = Tiefe
scene-capacity = Kapazität
scene-threshold = Schwelle
scene-quadtree-82 = 82 Punkte in der Ebene
scene-figure-1 = Abbildung 1: ein Binärbaum
scene-checker-cells = Schachbrettzellen
scene-rings = Bild mit Ringen
scene-figure-7 = Abbildung 7: gespiegelter Strahl
scene-points-3d = 300 Punkte im Raum
scene-sphere-grid = Kugelgitter
scene-cloud = Wolke aus 1890 Kugeln
scene-cylinders = 4320 Zylinder und Kugeln
scene-objects = 4350 Objekte
scene-spheres-512 = 512 Kugeln
scene-spheres-4096 = 4096 Kugeln
scene-spheres-32768 = 32768 Kugeln
scene-counts-points = { $items ->
    [one] 1 Punkt
   *[other] { $items } Punkte
}, { $leaves ->
    [one] 1 Blatt
   *[other] { $leaves } Blätter
}
scene-counts-cells = { $items ->
    [one] 1 Zelle
   *[other] { $items } Zellen
}, { $leaves ->
    [one] 1 Blatt
   *[other] { $leaves } Blätter
}
scene-counts-image = { $items ->
    [one] 1 Pixel
   *[other] { $items } Pixel
}, { $leaves ->
    [one] 1 Blatt
   *[other] { $leaves } Blätter
}
scene-counts-spheres = { $items ->
    [one] 1 Kugel
   *[other] { $items } Kugeln
}, { $leaves ->
    [one] 1 Blatt
   *[other] { $leaves } Blätter
}
scene-counts-boxes = { $items ->
    [one] 1 Quader
   *[other] { $items } Quader
}, { $leaves ->
    [one] 1 Blatt
   *[other] { $leaves } Blätter
}
scene-counts-triangles = { $items ->
    [one] 1 Dreieck
   *[other] { $items } Dreiecke
}, { $leaves ->
    [one] 1 Blatt
   *[other] { $leaves } Blätter
}

ray-origin = Startpunkt
ray-direction = Richtung
number-missing = Hier fehlt eine Zahl. Richtig wäre etwa −0.25, 3/4, 1e-3 oder 0x1.8p-1.
number-refused = „{ $typed }“ ist keine Zahl. Richtig wäre etwa −0.25, 3/4, 1e-3 oder 0x1.8p-1.
whole-refused = „{ $typed }“ ist keine ganze Zahl von { $least } bis { $most }: schreiben Sie eine.
range-refused = „{ $typed }“ ist keine Zahl von { $least } bis { $most }: schreiben Sie eine.
number-meanwhile = Bis dahin gilt { $value }; Esc bringt sie zurück.
number-restored = Es gilt wieder { $value }.
ray-refused = Ein Strahl braucht eine Richtung ungleich null; die letzte bleibt.

query-ray = Strahl
query-point = Punkt
query-region = Bereich
query-region-from = von
query-region-to = bis
query-neighbour = Nachbar
query-algorithm = Verfahren
query-first-full = Halt am ersten vollen Blatt
query-first-full-why = Der Durchlauf endet am ersten belegten Blatt, wie beim nächsten Treffer eines Raytracers.
query-rules-why = Regeln, die auch in anderer Form gehen: wie eine Arbeit es anders machte, oder wie der Aufsatz sie falsch gedruckt hat.
query-rules = Regeln{ $n ->
    [0] {""}
   *[other] {" "}({ $n })
}
query-rules-none = Keine Regel dieses Verfahrens gibt es in anderer Form.
query-segment-end = Ende bei t
variant-one-by-one = eine Ebene auf einmal
variant-one-by-one-why = Von Ebenen, die zugleich getroffen werden, wird nur eine gekreuzt: Unterwegs werden Zellen berührt.
variant-averaged = gemittelte Mittelebenen
variant-averaged-why = Das t einer Mittelebene ist das Mittel aus dem der nahen und der fernen Ebene, wie in Gleichung 13, samt Rundung.
variant-push = Austrittspunkt verschieben
variant-push-why = Um eine halbe kleinste Zelle längs der Normalen der Austrittsseite weiter, wie bei Glassner; nahe an Kanten kann es im Kreis gehen.
variant-gem = vergleichen wie im Gem
variant-gem-why = Wie von Sung und Shirley gedruckt: Gleiche Parameter und ein Startpunkt auf der Ebene sind nicht geregelt.
query-point-hint = Eine Zelle anklicken oder den Punkt ziehen. Esc führt zurück zum Strahl.
query-region-hint = Einen Kasten über die Zellen ziehen oder eine Ecke davon. Esc führt zurück zum Strahl.
query-neighbour-hint = Nahe an die Seite einer Zelle klicken oder eine Richtung wählen. Esc führt zurück zum Strahl.
arithmetic-doubles = Gleitkomma
arithmetic-doubles-why = Die Parameter t sind 64-Bit-Gleitkommazahlen und werden gerundet, wie in einem üblichen Programm.
arithmetic-exact = exakt
arithmetic-exact-why = Die Parameter t werden als exakte Brüche verglichen; die Schritte sagen, wo Gleitkommazahlen irren würden.
arithmetic-fixed-why = Jedes Blatt wird immer exakt geprüft: Am Ergebnis werden die anderen Verfahren gemessen.
point-codes = mit Codes
point-comparison = mit Vergleichen
reach-equal = auch größere
reach-leaf = Blatt
reach-every-leaf = alle Blätter
neighbour-codes = mit Codes
neighbour-tables = mit Tabellen
neighbour-cell = Zelle der Stufe { $level }, Codes { $codes }
neighbour-direction = Richtung

show-order-numbers = Reihenfolge
show-half-open-sides = halboffene Seiten
show-codes = Ortscodes
show-mirrored-ray = gespiegelter Strahl
show-content = Inhalt
show-empty-leaves = leere Blätter
show-ancestors = Vorfahren
show-children = Kinder
show-order-numbers-why = Die Nummern der besuchten Blätter in ihrer Reihenfolge längs des Strahls
show-half-open-sides-why = Jeder Zelle gehören ihre unteren Seiten, die oberen nicht; was ihr nicht gehört, ist gestrichelt
show-codes-why = Ortscodes, in die Zellen geschrieben
show-mirrored-ray-why = Der Strahl, so gespiegelt, dass keine Komponente negativ ist: So verfolgt ihn das parametrische Verfahren
show-content-why = Punkte, Bild oder Körper, aus denen der Baum gebaut ist
show-empty-leaves-why = Blätter, in denen nichts liegt
show-ancestors-why = Knoten von der Wurzel bis zum aktuellen
show-children-why = Kinder des aktuellen Knotens, ausgeschlossene gestrichelt
show-more-plane = welche Zellen, Abstand
show-more-space = welche Zellen, Schnitt, Abstand
show-inner-nodes = innere Knoten
show-inner-nodes-why = Auch innere Knoten abseits des Wegs, nicht nur Blätter
show-levels = Stufen
show-levels-why = Stufen der Zellen abseits des Wegs; 0 ist die der kleinsten
show-levels-least = kleinste gezeigte Stufe
show-levels-most = größte gezeigte Stufe
show-rest = übrige Zellen
show-rest-why = Wie die Zellen abseits des Wegs gezeichnet werden
show-rest-plain = normal
show-rest-plain-why = Zellen abseits des Wegs, wie sie sind
show-rest-faint = blass
show-rest-faint-why = Zellen abseits des Wegs als blasse Linien
show-rest-hidden = verborgen
show-rest-hidden-why = Nur der Weg
show-slice = Schnitt
show-slice-why = Eine Ebene, die den Octree aufschneidet: Was vor ihr liegt, fehlt, der Weg ausgenommen
show-slice-off = aus
show-slice-off-why = Der ganze Octree
show-slice-across = Schnitt quer zur { $axis }-Achse
show-slice-at = Lage des Schnitts
show-apart = Abstand
show-apart-why = Wie weit die Kinder des aktuellen Knotens auseinandergerückt sind, in ihren eigenen Seitenlängen

stack-empty = Auf dem Stapel liegt nichts.
stack-level = Stufe
stack-codes = Codes
stack-state = Zust.
stack-half = Hälfte
stack-whole = ganz
stack-interval = t
compare-sort = Nach { $column } ordnen
compare-algorithm = Verfahren
compare-algorithm-why = In der Reihenfolge des Menüs
counters-why = Groß: alle Schritte bisher. Mit +: in diesem Schritt. Gesamt: im ganzen Lauf.
compare-agrees = { $leaves } Blätter, die richtigen
compare-slivers = { $leaves } Blätter, laut Referenz { $expected }: In den übrigen ist der Strahl nicht länger, als Gleitkommazahlen unterscheiden
compare-differs = { $leaves } Blätter, andere als die Referenz
compare-leaves = Blätter
compare-leaves-why = Besuchte Blätter; = wenn es die der Referenz sind, ≠ wenn nicht
compare-steps = Schritte
compare-steps-why = Schritte, die die Spur zeigt
compare-nodes = Zugriffe
compare-nodes-why = Gelesene Verweise auf ein Kind oder den Elternknoten
compare-tests = Vergl.
compare-tests-why = Vergleiche von Koordinaten und Parametern, jeder Art
compare-quotients = Div.
compare-quotients-why = Divisionen
compare-none = Vergleicht die Verfahren, sobald nach einem Strahl gefragt wird.
compare-coming = Alle Verfahren folgen dem Strahl …
compare-too-many = Der Baum ist zu groß, um bei jeder Bewegung jedes Blatt zu prüfen, durch sein Raster zu laufen oder seine Knoten zu verbinden; was das bräuchte, fehlt hier.
timeline-name = Schritt der Aufzeichnung
timeline-number = Nummer des Schritts
timeline-speed = Geschwindigkeit
timeline-wrong = Schritt { $step } ist der erste, der schiefgeht
timeline-cut = Der Lauf ist länger: Nach so vielen Schritten endet die Aufzeichnung
timeline-why = Ein Strich je Schritt. Hoch: ein Blatt oder Ergebnis, Anfang und Ende. Von der Linie nach unten: in einen Knoten hinein. Nach oben: hinauf zu einem Vorfahren. Gelb: Das nächste Kind, die nächste Zelle oder Ebene wird gewählt. Violett: nur berührt. Kurz: gerechnet.
timeline-rounded = Schritte mit Dreieck: Gleitkommazahlen würden irren

tree-name = Baumansicht
tree-hint = Ziehen verschiebt, Strg mit dem Rad vergrößert; ein Doppelklick zeigt alles.
tree-key = An einem zugeklappten Knoten: Nummern der in ihm besuchten Blätter (1–5), sonst ihre Zahl (85).
tree-root = Wurzel
tree-child = Kind { $child }
tree-folded = { $n ->
    [one] ein Blatt eingeklappt
   *[other] { $n } Blätter eingeklappt
}
tree-visited = Nummer { $n } auf dem Strahl
tree-click-step = Klick: zu Schritt { $n }, dem ersten hierin
tree-shift-click = Umschalt und Klick: hier ausklappen
tree-click-unfold = { $n ->
    [one] Klick: ein Blatt ausklappen
   *[other] Klick: { $n } Blätter ausklappen
}
tree-click-fold = Klick: wieder einklappen
why-not-none = Zeigt, was die Kinder ausschließt, bei Suchen entlang eines Strahls oder nach einem Punkt.
why-not-leaf = Die Wurzel ist ein Blatt: Es gibt nichts zu wählen.
why-not-all = Kein Kind ist ausgeschlossen.
sentence-begin = Mit → geht es los.
job-open = { $name } wird geöffnet
job-restore = Das zuletzt Geöffnete wird geöffnet
job-trace = Ein langer Lauf wird aufgezeichnet
job-build = Der Baum wird gebaut
job-broken = Die Arbeit endete ohne Ergebnis. Versuchen Sie es noch einmal; geschieht es wieder, melden Sie es bitte.
job-cancel = Abbrechen
dialog-cancel = Abbrechen
dialog-close = Schließen
dialog-error = Das ging nicht
notes-title = Octoscope-Notizen
notes-blank = Das Fenster ist leer, niemand sieht etwas. B bringt es zurück.
notes-next = Danach
notes-end = Hier endet der Ablauf.
notes-restart = neu starten
find-theme = Farbschema: { $theme }
find-hint = Befehl, Szene, Verfahren oder Fehler des Aufsatzes
find-nothing = Nichts heißt so. Zu finden sind Befehle, Szenen, Verfahren und Fehler des Aufsatzes, auf Deutsch oder Englisch.
find-disabled = Für diesen Befehl gibt es gerade nichts zu tun.
find-command = Befehl
find-panel = Tafel
find-scene = Szene
find-query = Anfrage
find-query-ray = Strahl: die Blätter entlang von ihm
find-query-point = Punkt: in welchem Blatt er liegt
find-query-region = Region: der kleinste Knoten, der sie enthält
find-query-neighbour = Nachbarn einer Zelle
find-algorithm = Verfahren
find-erratum = Fehler des Aufsatzes
dialog-keys = Tasten
dialog-about = Über Octoscope
dialog-export = Ansicht exportieren
dialog-export-view = Was
path-open = Öffnen: Pfad eingeben
path-save = Speichern unter: Pfad eingeben
path-export = Exportieren: Pfad eingeben
path-open-hint = Dieses System zeigt keinen Dateidialog. Eine Datei lässt sich auch auf das Fenster ziehen.
path-hint = Dieses System zeigt keinen Dateidialog.
path-open-confirm = Öffnen
path-save-confirm = Speichern
path-export-confirm = Exportieren
path-replaces = Eine Datei dieses Namens gibt es schon. Soll sie ersetzt werden?
path-replace = Ersetzen
export-exercise = Aufgabe
export-own-ray = dieser Strahl
export-numbered = für jede Nummer ein neuer
export-seed = Nummer
export-solution = mit Lösung
export-moments = Momente
export-even = gleichmäßig
export-leaves = bei Blättern
export-listed = diese Schritte
export-at-most = höchstens
export-listed-wrong = Geben Sie Schritte von 0 bis { $last } mit Kommas dazwischen an, höchstens { $most }.
export-format = Format
export-extent = Seite
export-cropped = passend
export-wide = diese Breite
export-sized = diese Größe
export-size = Größe
export-width = Breite
export-height = Höhe
export-enlarged = Vergrößerung
export-type-scale = Schrift und Linien
export-line-scale = Linien allein
export-theme = Farben
export-background = Hintergrund
export-transparent = transparent
export-steps = Schritte
export-up-to-here = bis zu diesem
export-here = dieser
export-range = von … bis
export-all = alle
export-from = von
export-to = bis
export-pause = Sekunden je Schritt
export-slides = Folien (Beamer), eine je Schritt
export-snippet = nur das Bild, ohne Dokument
export-language = Sprache
export-notation = Schreibweise
export-show = Was zu sehen ist
export-preview = Vorschau der Abbildung
export-preview-step = Schritt { $step }, einer von { $first } bis { $last }
export-preview-rows = Die letzten { $shown } von { $steps } Schritten
export-preview-text = Der Text enthält alle { $steps } Schritte, dieses Bild { $first } bis { $last }
export-command = Dasselbe auf der Kommandozeile
export-copy-command = Kopieren
export-unsaved = Speichern Sie das Szenario zuerst als { $file }.
export-file = Datei
export-choose = Wählen …
export-nameless = Eine Datei nennen.
export-new = Wird geschrieben nach { $path }
export-replaces = Gibt es schon und wird ersetzt: { $path }
export-folder = Dies ist ein Ordner; einen Dateinamen anhängen: { $path }
export-do = Exportieren
export-copy-image = Als Bild kopieren
export-copy-svg = Als SVG kopieren
export-copy-table = Als Text kopieren
theme-light = hell
theme-dark = dunkel
theme-print = Druck
theme-projector = Beamer
job-export = { $name } wird exportiert
job-copy = Die Kopie wird gemacht
status-copied-image = Die Abbildung liegt als Bild in der Zwischenablage.
status-copied-svg = Die Abbildung liegt als SVG-Text in der Zwischenablage.
status-copied-table = Die Tabelle der Schritte liegt in der Zwischenablage.
status-copied-command = Der Befehl liegt in der Zwischenablage.
about-text = Octoscope zeigt geordnete Durchläufe von Quadtrees und Octrees Schritt für Schritt. Gegenstand ist der Aufsatz „Ray Tracing mit Octrees“ von M. Kirschmann, Ulm, mit den Verfahren, die er nennt.
about-licence = Version { $version }, unter der MIT- oder der Apache-Lizenz 2.0.
drop-here = Datei loslassen, um sie zu öffnen
status-no-ray = Diese Anfrage hat keinen Strahl. „Strahl“ unter Anfrage bringt den letzten zurück.
status-rules = Verfahren: { $algorithm }; { $rules }
status-rule-printed = Regel { $rule } wie gedruckt
status-back = Strg+Z führt zurück: { $before }
status-detour = Die gedruckte Regel kommt auf einem Umweg zum richtigen Ergebnis; er beginnt hier.
status-no-misprint = Alle Regeln gelten in ihrer richtigen Form; kein Druckfehler führt in die Irre. Die Werkstatt zum Aufsatz schaltet Druckfehler ein.
status-only-in-space = Das gilt für Octrees: Ein Quadtree wird nur von einer Seite gesehen.
status-largest = Größer wird die Schrift in diesem Fenster nicht.
status-smallest = Kleiner wird die Schrift nicht.
status-cancelled = Abgebrochen.
status-saving = { $name } wird gespeichert …
status-saved = Gespeichert als { $name }
status-kept = „{ $title }“ hatte Änderungen, die in keiner Datei stehen: Strg+Z bringt es zurück.
status-not-restored = Das zuletzt Geöffnete lässt sich jetzt nicht öffnen; der nächste Start versucht es wieder. { $why }
status-still-exporting = Ein Export oder eine Kopie wird noch gemacht. Warten Sie das Ende ab oder brechen Sie ab.
status-exported = Exportiert als { $path }
left-out-leaves = { $n } Blätter neben dem Strahl fehlen; Abbildungen zeigen höchstens { $most }
left-out-solids = { $n } Punkte oder Körper fehlen; Abbildungen zeigen höchstens { $most }
left-out-right = richtig und falsch ist nicht markiert; geprüft werden Läufe bis zum Ende, in Bäumen bis { $most } Blätter
left-out-rows = die Tabelle zeigt die letzten { $shown } von { $steps } Schritten

paper-none = Keine Regel dieses Verfahrens ist im Aufsatz falsch gedruckt.
paper-counterexample = Gegenbeispiel laden
paper-too-large = Der Baum ist zu groß, um Blatt für Blatt geprüft zu werden.
paper-coming = Der Lauf wird Blatt für Blatt geprüft …
paper-agrees = Bei dieser Eingabe schadet die gedruckte Regel nicht.
paper-longer = Kommt zum richtigen Ergebnis, aber mit { $steps } Schritten statt { $right }. Der Umweg beginnt bei Schritt { $step }.
paper-longer-short = Richtig, aber in { $steps } statt { $right } Schritten, ab Schritt { $step }.
paper-marks = Gepunktet: was richtig wäre; durchgestrichen: was falsch gemeldet wird.
paper-marks-mirrored = Gestrichelt ist der gespiegelte Strahl, berichtigt und, in Violett, wie gedruckt. Gepunktet ist, was richtig wäre.
paper-wrong = Geht bei Schritt { $step } schief.
paper-go = Zu diesem Schritt
paper-other = Anderen Strahl suchen, bei dem sie abweichen
paper-other-point = Anderen Punkt suchen, bei dem sie abweichen
paper-other-region = Anderes Gebiet suchen, bei dem sie abweichen
paper-other-cell = Andere Zelle suchen, bei der sie abweichen
paper-no-other = Nichts anderes gefunden, bei dem gedruckte und richtige Regel abweichen; ein Baum mit mehr Stufen könnte helfen.
paper-printed = Wie gedruckt
paper-right = Berichtigt
paper-all = Alle Fehler des Aufsatzes „Ray Tracing mit Octrees“
paper-severity-wrong = führt zu einem falschen Ergebnis
paper-severity-misleading = führt den Leser irre
paper-severity-cosmetic = ein bloßer Schreibfehler
paper-try = { $variant } ausprobieren
job-other = Ein anderes Gegenbeispiel wird gesucht

map-none = Keine Karte: Sie zeigt, was aus vielen Strahlen wird, aber { $asked ->
    [query-point] ein Punkt wird gesucht
    [query-region] ein Bereich wird gesucht
   *[query-neighbour] ein Nachbar wird gesucht
}. Esc führt zurück zum Strahl.
map-rays-origin = Vom Startpunkt
map-rays-picture = Wie gesehen
map-colouring = Was die Farben sagen
map-sequence = Besuchte Folge
map-leaves = Anzahl der besuchten Blätter
map-steps = Schritte des Verfahrens
map-comparisons = Vergleiche des Verfahrens
map-differences = Richtig oder falsch
map-ray = Ganzer Strahl: { $leaves ->
    [one] 1 Blatt
   *[other] { $leaves } Blätter
}, { $steps ->
    [one] 1 Schritt
   *[other] { $steps } Schritte
}, { $comparisons ->
    [one] 1 Vergleich
   *[other] { $comparisons } Vergleiche
}
map-ray-long = Sein Lauf ist zu lang, um ihn hier zu zählen
map-axis-angle = Winkel der Richtung (°)
map-axis-offset = Abstand von der Mitte
map-axis-turn = Zur Seite (°)
map-axis-rise = Nach oben (°)
map-extent-picture = Die Sehstrahlen der Raumansicht
map-sequence-legend = Andere Farbe: andere Blätter oder andere Reihenfolge
map-legend-nothing = Kein Blatt
map-legend-right = Richtig
map-legend-ray = Aktueller Strahl
map-legend-ray-seen = Aktueller Strahl, von hier gesehen: er ist kein Sehstrahl
map-legend-ray-beyond = Der aktuelle Strahl liegt jenseits der Seiten der Karte
map-differences-legend = { $wrong ->
    [0] Keiner von { $rays } Strahlen wird falsch verfolgt
    [one] 1 von { $rays } Strahlen wird falsch verfolgt
   *[other] { $wrong } von { $rays } Strahlen werden falsch verfolgt
}
map-unknown-legend = { $rays ->
    [one] Grau: Ein Lauf wurde nach einer Million Schritten abgebrochen, bis dahin richtig
   *[other] Grau: { $rays } Läufe wurden nach einer Million Schritten abgebrochen, bis dahin richtig
}
map-by-batch = Für viele Strahlen zugleich berechnet, exakt
map-by-batch-right = Farben: die richtige Suche, für viele Strahlen zugleich berechnet. Nur die Zeile darüber folgt der gedruckten Regel
map-by-algorithm = Im gezeigten Verfahren gezählt, Strahl für Strahl
map-by-both = Das gezeigte Verfahren, verglichen mit einer exakten Suche
map-progress = Die Karte entsteht

notation-seed = Wie in „Ray Tracing mit Octrees“
notation-revelles = Wie bei Revelles, Ureña und Lastra
notation-frisken-perry = Wie bei Frisken und Perry
notation-now = Formeln: { $notation }. { $key } wechselt zur nächsten Schreibweise.

# Andere Wörter, unter denen etwas gesucht wird, zwischen Kommas.
also-command-preset-lecture = Vortrag, Präsentation, Hörsaal, Folien
also-command-next-theme = Farben, hell, dunkel, Druck, Beamer, Projektor
also-theme-projector = Projektor, Hörsaal
also-theme-print = Papier
also-command-go-to-step = gehe, springen, Nummer
also-command-export = Abbildung, Bild, SVG, PDF, PNG, GIF, TikZ, LaTeX, Folien, Arbeitsblatt, Bildfolge
also-command-blank = schwarz
also-command-lab = Benchmark, messen, Zeit
also-command-next-language = Deutsch, Englisch
also-command-snap-ray = entartet
