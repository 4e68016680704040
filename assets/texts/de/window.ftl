# Texte des Fensters, auf Deutsch.

menu-file = Datei
menu-edit = Bearbeiten
menu-view = Ansicht
menu-panels = Tafeln
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
command-restore-panels = Anordnung zurücksetzen
command-frame-all = Alles zeigen
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
command-last = Zum Ende
command-play = Abspielen oder anhalten
command-faster = Schneller abspielen
command-slower = Langsamer abspielen
command-keys = Tasten
command-about = Über Octoscope

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
panel-menu = Tafel { $title }
panel-fold = Einklappen
panel-unfold = Ausklappen
panel-up = Nach oben
panel-down = Nach unten
panel-close = Schließen
space-name = Raumansicht
space-click-neighbour = Klick: der Nachbar jenseits dieser Seite

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
ray-refused = Ein Strahl braucht eine Richtung ungleich null; die letzte bleibt.

query-ray = Strahl
query-point = Punkt
query-region = Bereich
query-neighbour = Nachbar
query-algorithm = Verfahren
query-first-full = Halt am ersten vollen Blatt
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
query-point-hint = Eine Zelle anklicken, um einen Punkt darin zu lokalisieren. Esc führt zurück zum Strahl.
query-region-hint = Einen Kasten über die Zellen ziehen. Esc führt zurück zum Strahl.
query-neighbour-hint = Nahe an die Seite einer Zelle klicken oder eine Richtung wählen. Esc führt zurück zum Strahl.
arithmetic-doubles = Gleitkomma
arithmetic-exact = exakt
point-codes = durch Codes
point-comparison = durch Vergleiche
reach-equal = gleich groß oder größer
reach-leaf = Blatt
reach-every-leaf = alle Blätter
neighbour-codes = mit Codes
neighbour-tables = mit Tabellen
neighbour-cell = Zelle der Ebene { $level }, Codes { $codes }
neighbour-direction = Richtung

show-order-numbers = Reihenfolge
show-half-open-sides = halboffene Seiten
show-codes = Ortscodes
show-mirrored-ray = gespiegelter Strahl
show-content = Inhalt
show-empty-leaves = leere Blätter
show-ancestors = Vorfahren
show-children = Kinder

codes-child-rule = Kind = { $rule }
codes-child = Bit { $bit } jedes Codes: { $bits }, also Kind { $child } ({ $morton } in Morton-Reihenfolge).
codes-morton = Morton-Code { $code }
region-none = Zeigt die Codes der Ecken, sobald ein Bereich lokalisiert wird.
region-same = Alle Bits stimmen überein: eine Zelle der Ebene 0.
region-level = Höchste Eins: Bit { $bit }. Plus 1: Ebene { $level }.
neighbour-none = Zeigt, wie die Codes jenseits einer Zelle entstehen, sobald sie verlassen wird.
neighbour-new = neu
neighbour-carry = Überträge markiert
neighbour-borrow = Überträge markiert
neighbour-climb = Ebene { $level }
neighbour-inside = Innerhalb des Gebiets: die Suche geht weiter.
neighbour-outside = Außerhalb des Gebiets auf { $axes }: dahinter ist nichts.
neighbour-ancestor = Aufgestiegen zu Ebene { $climbed } von { $level }.
node-note = Ebene { $level }, Codes { $codes }
t-rail-none = Zeigt die Parameter t, sobald der Strahl geschnitten ist.
t-rail-enter = Eintritt
t-rail-exit = Austritt
automaton-mask = a = { $mask }: Zustand i ist Kind i xor { $mask }
automaton-state = Zustand { $state }
automaton-state-column = Zustand
automaton-end = Ende
automaton-table-1 = Tabelle 1: Austrittsebene
automaton-table-3 = Tabelle 3: Austrittsebene
automaton-table-2 = Tabelle 2: Eintrittsebene, und was ein Bit setzt
stack-empty = Auf dem Stapel liegt nichts.
stack-level = Ebene
stack-codes = Codes
stack-state = Zust.
stack-half = Hälfte
stack-interval = t
counters-step = Schritt
counters-so-far = bisher
counters-total = gesamt
counters-comparisons = Vergleiche
counters-all = Alle Zähler
compare-agrees = { $leaves } Blätter, die richtigen
compare-differs = { $leaves } Blätter, andere als die Referenz
compare-leaves = Blätter
compare-leaves-why = Besuchte Blätter; = wenn es die der Referenz sind, ≠ wenn nicht
compare-steps = Schritte
compare-steps-why = Schritte, die die Spur zeigt
compare-nodes = Knoten
compare-nodes-why = Gelesene Verweise auf ein Kind oder den Elternknoten
compare-tests = Vergl.
compare-tests-why = Vergleiche von Koordinaten und Parametern, jeder Art
compare-quotients = Div.
compare-quotients-why = Divisionen
compare-none = Vergleicht die Verfahren, sobald nach einem Strahl gefragt wird.
compare-too-many = Der Baum ist zu groß, um bei jeder Bewegung jedes Blatt zu prüfen, durch sein Raster zu laufen oder seine Knoten zu verbinden; was das bräuchte, fehlt hier.
timeline-name = Schritt der Aufzeichnung
timeline-speed = Geschwindigkeit
timeline-rounded = Schritte mit Dreieck: Gleitkommazahlen würden irren

sentence-begin = Mit → geht es los.
job-open = { $name } wird geöffnet
job-restore = Das zuletzt Geöffnete wird geöffnet
job-build = Der Baum wird gebaut
job-broken = Die Arbeit endete ohne Ergebnis. Versuchen Sie es noch einmal; geschieht es wieder, melden Sie es bitte.
job-cancel = Abbrechen
dialog-close = Schließen
dialog-error = Das ging nicht
dialog-keys = Tasten
dialog-about = Über Octoscope
dialog-path = Eine Datei öffnen
dialog-path-hint = Es ließ sich kein Dateidialog öffnen. Geben Sie einen Pfad ein oder ziehen Sie eine Datei auf das Fenster.
dialog-path-open = Öffnen
dialog-export = Ansicht exportieren
export-format = Format
export-extent = Seite
export-cropped = um die Abbildung
export-sized = von dieser Größe
export-size = Größe
export-width = Breite
export-height = Höhe
export-enlarged = Vergrößerung
export-type-scale = Schrift und Linien
export-theme = Farben
export-background = Hintergrund
export-transparent = durchsichtig
export-steps = Schritte
export-here = dieser
export-range = von, bis
export-all = alle
export-from = von
export-to = bis
export-pause = Sekunden je Schritt
export-slides = Folien (Beamer), eine je Schritt
export-snippet = nur das Bild, kein Dokument
export-language = Sprache
export-show = Was zu sehen ist
export-preview = Vorschau der Abbildung
export-command = Dasselbe auf der Kommandozeile
export-copy-command = Kopieren
export-unsaved = Speichern Sie das Szenario zuerst als { $file }.
export-file = Datei
export-choose = Wählen …
export-replaces = Diese Datei gibt es schon; sie wird ersetzt.
export-do = Exportieren
export-copy-image = Als Bild kopieren
export-copy-svg = Als SVG kopieren
theme-light = hell
theme-dark = dunkel
theme-print = Druck
theme-projector = Beamer
job-export = { $name } wird exportiert
status-copied-image = Die Abbildung liegt als Bild in der Zwischenablage.
status-copied-svg = Die Abbildung liegt als SVG-Text in der Zwischenablage.
status-copied-command = Der Befehl liegt in der Zwischenablage.
about-text = Octoscope zeigt geordnete Durchläufe von Quadtrees und Octrees Schritt für Schritt. Gegenstand ist die Seminararbeit „Ray Tracing mit Octrees“ von M. Kirschmann, Ulm, mit den Verfahren, die sie nennt.
about-licence = Version { $version }, unter der MIT- oder der Apache-Lizenz 2.0.
drop-here = Datei loslassen, um sie zu öffnen
status-saved = Gespeichert als { $name }
status-exported = Exportiert als { $name }

paper-none = Keine Regel dieses Verfahrens ist im Aufsatz falsch gedruckt.
paper-counterexample = Gegenbeispiel laden
paper-too-large = Der Baum ist zu groß, um Blatt für Blatt geprüft zu werden.
paper-agrees = Bei dieser Eingabe schadet die gedruckte Regel nicht.
paper-wrong = Geht bei Schritt { $step } schief.
paper-go = Zu diesem Schritt
paper-other = Anderen Strahl suchen, bei dem sie abweichen
paper-no-other = Kein Strahl gefunden, bei dem gedruckte und richtige Regel abweichen; ein Baum mit mehr Ebenen könnte helfen.
paper-printed = Wie gedruckt
paper-right = Berichtigt
paper-all = Alle Errata von „Ray Tracing mit Octrees“
paper-try = { $variant } ausprobieren
job-other-ray = Ein anderer Strahl wird gesucht …

