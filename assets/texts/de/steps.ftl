# Was in jedem Schritt geschieht. Argumente können Farben tragen: ganz lassen.

and = { $first } und { $last }
comma = { $first }, { $last }

by-parametric = mit dem parametrischen Verfahren
by-parametric-table = mit dem parametrischen Verfahren und seinen Tabellen
by-esvo = mit der parametrischen Regel ohne Rekursion
by-all-children = mit der Prüfung jedes Kindes
by-hero = mit Maske und sortierten Mittelebenen nach HERO
by-gargantini = mit der Zuordnung der Stücke zwischen sortierten Schnitten
by-codes = mit Ortscodes
by-glassner = mit der Ortung jedes Austrittspunkts von der Wurzel aus
by-samet = mit Nachbartabellen
by-samet-corner = mit der Ecke der Austrittsebenen
by-samet-net = über Verweise zwischen Nachbarn
by-bsp = mit binärer Raumteilung
by-dda = auf dem feinsten Raster
by-dda-octree = auf dem feinsten Raster, dessen Zellen im Baum nachgeschlagen werden,
by-exhaustive = mit der Prüfung jedes einzelnen Blattes

start-ray = Ein Strahl von { $origin } in Richtung { $direction } wird { $algorithm } durch den { $tree } verfolgt.
start-printed-one = { " " }Regel { $rules } gilt, wie sie gedruckt ist.
start-printed-many = { " " }Die Regeln { $rules } gelten, wie sie gedruckt sind.
start-one-by-one = { " " }Ebenen, die zugleich getroffen werden, werden eine nach der anderen gekreuzt.
start-averaged = { " " }Das t einer Mittelebene ist das Mittel aus denen der nahen und der fernen Ebene.
start-push = { " " }Der Austrittspunkt wird aus jedem Blatt hinausgeschoben.
start-gem = { " " }Die Hälften werden mit den Vergleichen des Gems gewählt.
start-point-codes = Das Blatt, dem der Punkt { $point } gehört, wird mit Ortscodes gesucht.
start-point-comparison = Das Blatt, dem der Punkt { $point } gehört, wird durch Vergleich mit den Mittelebenen gesucht.
start-region = Der kleinste Knoten, der einen Bereich enthält, wird mit Ortscodes gesucht.
start-neighbour-tables = Der Nachbar von { $node } in Richtung { $direction } wird mit Tabellen gesucht.
start-neighbour = Der Nachbar von { $node } in Richtung { $direction } wird mit Ortscodes gesucht.
quadtree = Quadtree
octree = Octree

clip-hit = Der Strahl durchquert die Wurzel: Er trifft die letzte nahe Ebene vor der ersten fernen, { $enter } < { $exit }.
clip-inside = Der Strahl beginnt innerhalb der Wurzel: Die letzte nahe Ebene kommt nicht nach t = 0, die erste ferne wohl, { $enter } ≤ 0 < { $exit }.
clip-mirror = { " " }Entlang { $axes } ist seine Richtung negativ; Zustand i steht daher für Kind f(i) = i xor { $mask }.
clip-mask = { " " }Entlang { $axes } ist seine Richtung negativ; dort kommt daher die obere Hälfte zuerst: Die Maske ist { $mask }.
clip-falls = { " " }Entlang { $axes } ist seine Richtung negativ; dort sind daher die unteren Ebenen die fernen.
clip-behind = Der Strahl verfehlt die Wurzel, die hinter seinem Startpunkt liegt: Schon für die erste ferne Ebene gilt { $exit } ≤ 0.
clip-miss = Der Strahl verfehlt die Wurzel: Er trifft eine ferne Ebene nicht später als die letzte nahe, { $exit } { $relation } { $enter }.
clip-short = Der Strahl endet, bevor er die Wurzel trifft, deren letzte nahe Ebene bei { $enter } liegt.
clip-no-length = Der Strahl verfehlt die Wurzel: Er endet bei { $end }, nicht später, als er beginnt.
clip-printed = { $by } wird die Wurzel getroffen, von t = { $enter } bis t = { $exit }.
by-printed-one = Nach der gedruckten Regel, { $rules },
by-printed-many = Nach den gedruckten Regeln, { $rules },
as-printed-one = { " " }So sagt es die gedruckte Regel, { $rules }.
as-printed-many = { " " }So sagen es die gedruckten Regeln, { $rules }.
clip-no-number = { " " }Aber { $parameters } ist keine Zahl, sodass kein Vergleich damit zutrifft und nichts davon abhängt.
clip-no-numbers = { " " }Aber { $parameters } sind keine Zahlen, sodass kein Vergleich damit zutrifft und nichts davon abhängt.
clip-printed-miss = { $by } wird die Wurzel verfehlt, mit t_min = { $enter } und t_max = { $exit }.
clip-parallel = Der Strahl verfehlt die Wurzel: Entlang { $axes } bewegt er sich nicht, und sein Startpunkt liegt dort außerhalb.

test-hit = { $node } wird zwischen t = { $enter } und t = { $exit } getroffen.
test-touch = { $node } wird nur in einem Punkt getroffen, bei t = { $at }.
test-miss = { $node } wird vom Strahl nicht getroffen.
sort = { $n ->
    [0] Kein Blatt wird getroffen, es gibt also nichts zu sortieren.
    [one] Nur ein Blatt wird getroffen, es steht also schon in der richtigen Reihenfolge.
   *[other] Die { $n } getroffenen Blätter werden nach dem t ihres Eintritts sortiert.
}

visit-root = Die Traversierung beginnt an der Wurzel, { $node }.
visit-plain = Kind { $child } wird besucht: { $node }.
visit-morton = { $number } wird als x + 2y + 4z gelesen, { $rule }, meint also Kind { $child } des Baums; es wird besucht: { $node }.
visit-mirrored = Zustand { $state } ist Kind { $child }, denn f({ $state }) = { $state } xor { $mask } = { $child }; es wird besucht: { $node }.
skip-behind = Der Knoten wird bei { $exit } < 0 verlassen; er liegt also hinter dem Startpunkt und wird übersprungen.
skip-ahead = Der Knoten wird bei { $exit } ≥ 0 verlassen; er liegt also nicht hinter dem Startpunkt.
halve = Der Strahl trifft die Mittelebenen des Knotens bei { $mid }.
halve-mean = { " " }Das sind die Mittel der Parameter der nahen und fernen Ebenen.
halve-unselected = { " " }Keiner ist der kleinere, und die gedruckte Regel, { $rule }, hat dafür keinen Zweig: Es wird kein Kind gewählt.
halve-still = { " " }Entlang { $axes } bewegt er sich nicht: Dort heißt ∞ stets untere Hälfte, −∞ stets obere.
first-one = { $comparisons }, also ist das { $axes }-Bit 1: Der Strahl { $inside ->
    [yes] beginnt
   *[no] tritt
} in der oberen { $axes }-Hälfte{ $inside ->
    [yes] {""}
   *[no] { " " }ein
}, im Zustand { $state }.
first-many = { $comparisons }, also sind die Bits von { $axes } 1: Der Strahl { $inside ->
    [yes] beginnt
   *[no] tritt
} in den oberen Hälften von { $axes }{ $inside ->
    [yes] {""}
   *[no] { " " }ein
}, im Zustand { $state }.
first-printed = { $by } tritt der Strahl im Zustand { $state } ein.
selection-printed = { $by } werden die Kinder besucht, die zu { $states } gehören.
states-one = Zustand { $states }
states-many = den Zuständen { $states }
first-none = { $comparisons }, also ist kein Bit gesetzt: Der Strahl { $inside ->
    [yes] beginnt
   *[no] tritt
} im Zustand 0{ $inside ->
    [yes] {""}
   *[no] { " " }ein
}.

step-one = { $child } wird an der { $axes }-Ebene verlassen: { $exits }, also wird das { $axes }-Bit 1: Zustand { $next }.
step-many = { $child } wird an den Ebenen von { $axes } zugleich verlassen: { $exits }, also werden ihre Bits 1: Zustand { $next }.
step-end-one = { $child } wird an der { $axes }-Ebene verlassen: { $exits }. In { $done } ist es die obere Hälfte: Auch der Elternknoten ist erledigt.
step-end-many = { $child } wird an den Ebenen von { $axes } zugleich verlassen: { $exits }. In { $done } ist es die obere Hälfte: Auch der Elternknoten ist erledigt.
child = Kind { $state }
state = Zustand { $state }
up = { $child } ist erledigt: zurück hinauf zu { $node }.
up-behind = { $child } wird bei { $exit } ≤ 0 verlassen; es liegt also hinter dem Startpunkt und wird übersprungen: zurück hinauf zu { $node }.
up-none = Die Wurzel ist erledigt.

enter = Der Strahl ist von t = { $enter } bis t = { $exit } in { $node }.
cuts = { $n ->
    [0] Der Strahl trifft keine Mittelebene im Inneren des Knotens; er bleibt also in einem Kind.
    [one] Von den sortierten Mittelebenen liegt eine im Intervall des Knotens: { $cuts }.
   *[other] Von den sortierten Mittelebenen liegen { $n } im Intervall des Knotens: { $cuts }.
}
classify = Bei t = { $at } gilt { $comparisons }: Der Strahl ist in Kind { $child }.
flip-one = Bei t = { $at } wird die Mittelebene von { $axes } gekreuzt: Ihr Bit kippt, und das nächste Kind ist { $child }.
flip-many = Bei t = { $at } werden die Mittelebenen von { $axes } zugleich gekreuzt: Ihre Bits kippen zusammen, und das nächste Kind ist { $child }.
split-near = { $at } liegt nicht vor dem Austritt bei { $exit }: Die Ebene wird nicht erreicht, nur die { $half } wird betreten.
split-behind = { $at } ≤ 0: Die Ebene wird nach dem Startpunkt nicht getroffen, nur die { $half } wird betreten.
split-still = Entlang { $axis } bewegt sich der Strahl nicht: Nur die Hälfte seines Startpunkts wird betreten, die { $half }.
split-far = { $at } liegt nicht nach dem Eintritt bei { $enter }: Die Ebene ist passiert, nur die { $half } wird betreten.
split-both = { $at } liegt zwischen { $enter } und { $exit }: Zuerst wird die { $half } betreten, die andere wartet auf dem Stapel.
split-gem-after = { $at } > { $exit }: Das Gem nimmt nur die Hälfte auf der Seite des Startpunkts, die { $half }.
split-gem-behind = { $at } < 0: Das Gem nimmt nur die Hälfte auf der Seite des Startpunkts, die { $half }.
split-gem-far = { $at } < { $enter }: Das Gem nimmt nur die Hälfte jenseits der Ebene, die { $half }.
split-gem-both = { $at } ist weder größer als { $exit } noch kleiner als 0 oder { $enter }: Das Gem nimmt beide Hälften, zuerst die { $half }; die andere wartet auf dem Stapel.
split-gem-no-number = { $at } ist keine Zahl, sodass kein Vergleich mit { $exit }, 0 oder { $enter } zutrifft: Das Gem nimmt beide Hälften, zuerst die { $half }; die andere wartet auf dem Stapel.
upper-half = obere { $axis }-Hälfte
lower-half = untere { $axis }-Hälfte
pop-node = Vom Stapel kommt { $node }; der Strahl ist von t = { $enter } bis t = { $exit } darin.
pop-half = Vom Stapel kommt ein Teil von { $node }; der Strahl ist von t = { $enter } bis t = { $exit } in diesem Teil.
grid = Die erste Zelle des Rasters ist { $cell }; die nächsten Ebenen werden bei { $planes } getroffen.
cross-one = { $planes }, also kreuzt der Strahl die { $axes }-Ebene: weiter zu Zelle { $cell }.
cross-out-one = { $planes }, also kreuzt der Strahl die { $axes }-Ebene und verlässt das Raster.
cross-out-many = { $planes }, also kreuzt der Strahl die Ebenen von { $axes } zugleich und verlässt das Raster.
cross-many = { $planes }, also kreuzt der Strahl die Ebenen von { $axes } zugleich: weiter zu Zelle { $cell }.
tie-first = { " " }Von gleichen Parametern zählt die erste Achse.
tie-last = { " " }Von gleichen Parametern zählt die letzte Achse.
parent-all = Kind { $child } liegt an der Seite { $direction } seines Elternknotens, also liegt der Nachbar auch jenseits des Elternknotens: hinauf zu { $node }.
parent-part = Von der Richtung { $direction } liegt Kind { $child } an der Seite { $common } seines Elternknotens: hinauf zu { $node } und in dieser Richtung weiter.
parent-holds = Kind { $child } liegt nicht an der Seite { $direction } seines Elternknotens, also enthält der Elternknoten den Nachbarn: hinauf zu { $node }.
mirror = Gespiegelt wird Kind { $child } zu Kind { $mirrored }: hinab zu { $node }.
facing = Kind { $child } ist der Zelle zugewandt, von der die Suche ausging: hinab zu { $node }.
rope = Der Verweis durch die { $axis }-Seite führt zu { $node }.
rope-spans = { " " }Dieser reicht auch über die { $axes }-Seite hinaus, deshalb wird dort keinem weiteren Verweis gefolgt.
rope-border = Durch die { $axis }-Seite führt kein Verweis: Sie ist der Rand.
push = Der Austrittspunkt { $from } wird entlang { $axis } nach { $to } verschoben.

begin-root = Die Suche beginnt an der Wurzel, { $node }.
begin-node = Die Suche beginnt bei { $node }.
encode = Der Punkt { $point } hat binär die Ortscodes { $codes }.
encode-ray = Unmittelbar nach t = { $after }, nahe { $point }, ist der Strahl in der kleinsten Zelle mit den Ortscodes { $codes }, binär geschrieben.
compare = { $comparisons }, also liegt der Punkt in Kind { $child }: { $node }.
follow = Bit { $bit } der Codes ist { $bits } und wählt Kind { $child }: { $node }.
follow-printed = { $by } wird Bit { $bit } der Codes gelesen. Es ist { $bits } und wählt Kind { $child }: { $node }.
follow-difference = { $by } wird Bit { $bit } der Differenzen gelesen. Es ist { $bits } und wählt Kind { $child }: { $node }.
bit-of = { $value } in { $axis }
exits-one = Das Blatt wird durch die Ebene { $planes } verlassen: { $exits }.
exits-many = Das Blatt wird durch die Ebenen { $planes } zugleich verlassen: { $exits }.
target = Dahinter, entlang { $axes }, sind die Codes { $to } statt { $from }.
target-printed = { $by } sind die Codes dahinter, entlang { $axes }, { $to }.
border-inside = Diese Codes liegen im Gebiet; dahinter ist also eine Zelle.
border-outside = Entlang { $axes } liegt der Code außerhalb des Gebiets; dahinter ist also keine Zelle.
border-point-outside = Entlang { $axes } liegt der Punkt außerhalb des Gebiets; dahinter ist also keine Zelle.
difference = Die Codes unterscheiden sich zuerst in Bit { $bit }, also liegt der gemeinsame Vorfahr auf Stufe { $level }.
difference-printed = { $by } hat der gemeinsame Vorfahr Stufe { $level }. Die Codes unterscheiden sich aber zuerst in Bit { $bit }, also hat er Stufe { $right }.
difference-none = Die Codes sind gleich, also liegen beide Orte in einer kleinsten Zelle, auf Stufe 0.
climb = Hinauf zum Elternknoten, { $node }; der gemeinsame Vorfahr liegt auf Stufe { $level }.
climb-done = Hinauf zum Elternknoten, { $node }; dies ist der gemeinsame Vorfahr.
leave-one = Das Blatt wird durch seine ferne { $axes }-Ebene verlassen: { $exits }.
leave-many = Das Blatt wird durch seine fernen Ebenen von { $axes } zugleich verlassen: { $exits }.
resume = Zurück zu { $node }, der auf dem Weg hinab behalten wurde.
corners = Die Ecken { $min } und { $max } des Bereichs haben binär die Codes { $from } und { $to }.

leaf-full = { $node } liegt von t = { $enter } bis t = { $exit } auf dem Strahl und ist belegt.
leaf-printed = { $by } wird { $node } gemeldet, von t = { $enter } bis t = { $exit }.
leaf-empty = { $node } liegt von t = { $enter } bis t = { $exit } auf dem Strahl und ist leer.
touch-printed = { $by } führt der Weg zu { $node }, der aber bei t = { $at } verlassen würde, nicht später, als er betreten wird: Er wird nicht gemeldet.
touch = { $node } wird nur berührt, in einem Punkt bei t = { $at }.
found-leaf = Gefunden: { $node }, ein Blatt.
found-node = Gefunden: { $node }, ein Knoten mit Kindern.
end-missed = Der Strahl trifft kein Blatt: Die Traversierung endet.
end-left-root = Der Strahl hat die Wurzel verlassen: Die Traversierung endet nach { $n ->
    [one] einem Blatt
   *[other] { $n } Blättern
}.
end-printed = Kein Knoten ist mehr übrig: Die Traversierung endet nach { $n ->
    [one] einem Blatt
   *[other] { $n } Blättern
}.
end-segment = Der Strahl endet hier: Die Traversierung endet nach { $n ->
    [one] einem Blatt
   *[other] { $n } Blättern
}.
end-cut = Hier endet die Aufzeichnung, nicht der Lauf: Er hat mehr als { $n } Schritte, und mehr werden nicht aufgehoben.
end-looped = Der Strahl kommt nicht weiter: Dieselben Blätter würden einander endlos folgen, daher wird abgebrochen.
end-first-full = Das erste belegte Blatt ist erreicht, mehr war nicht verlangt: Die Traversierung endet.
end-found-leaf = Die Suche endet: Gefunden ist { $node }, ein Blatt.
end-found-node = Die Suche endet: Gefunden ist { $node }, der Kinder hat.
end-outside = Der Ort liegt außerhalb des Gebiets: Es gibt nichts zu finden.
end-outside-axes = Die Suche endet: Entlang { $axes } läge der Nachbar außerhalb des Gebiets, es gibt also keinen.

the-node = Knoten { $code } auf Stufe { $level }
the-node-first = Knoten { $code } auf Stufe { $level }
the-leaf = Blatt { $code } auf Stufe { $level }

title = { $tree } · { $scene } · { $n ->
    [one] ein Blatt
   *[other] { $n } Blätter
}
title-quadtree = Quadtree
title-octree = Octree
scene-inline = eigene Daten

algorithm-parametric = Parametrisch, eine Regel
algorithm-parametric-table = Parametrisch, Tabellen
algorithm-esvo = Parametrisch, iterativ
algorithm-all-children = Jedes Kind geprüft
algorithm-hero = HERO: sortierte Ebenen
algorithm-gargantini = Gargantini: Schnitte
algorithm-codes = Ortscodes
algorithm-glassner = Glassner: ab der Wurzel
algorithm-samet = Samet: Nachbartabellen
algorithm-samet-corner = SametCorner (rekonstruiert)
algorithm-samet-net = SametNet (rekonstruiert)
algorithm-bsp = Sung–Shirley: binär
algorithm-dda = Amanatides–Woo: Raster
algorithm-dda-octree = Raster, im Baum gesucht
algorithm-exhaustive = Jedes Blatt, exakt

query-ray = Strahl
query-point = Punkt
query-region = Bereich
query-neighbour = Nachbar

ended-missed = Wurzel verfehlt
ended-left-root = Wurzel verlassen
ended-first-full = Erstes belegtes Blatt
ended-segment-end = Ende der Strecke
ended-cut = Abgebrochen: zu viele Schritte
ended-looped = Läuft im Kreis
ended-found = Gefunden
ended-outside = Außerhalb des Gebiets

counter-node-touches = Zugriffe
counter-leaf-tests = Blatttests
counter-entry-comparisons = Vergleiche, Eintritt
counter-exit-comparisons = Vergleiche, Austritt
counter-range-comparisons = Vergleiche, Bereich
counter-code-comparisons = Vergleiche, Codes
counter-sort-comparisons = Vergleiche, Sortieren
counter-divisions = Divisionen
counter-additions = Summen, Produkte
counter-bit-operations = Bitoperationen
counter-transitions = Übergänge
counter-table-lookups = Nachschlagen in Tabellen
counter-grid-cells = Rasterzellen
counter-point-locations = Punktortungen
counter-ascends = Aufstiege
counter-descends = Abstiege
counter-calls = Rekursive Aufrufe
counter-stack-depth = Stapeltiefe
counter-leaves = Blätter
counter-touches = Berührungen

# Was aus einem Knoten wird, und warum.
fate-child = Kind { $child }
fate-root = Die Wurzel
fate-visited-ray = { $who } ist besucht: Der Strahl ist darin von t = { $enter } bis t = { $exit }.
fate-visited-point = { $who } enthält den Punkt.
fate-entered-ray = { $who } wird gerade durchsucht: Der Strahl ist darin von t = { $enter } bis t = { $exit }.
fate-entered-point = { $who } wird gerade durchsucht, denn der Punkt liegt darin.
fate-ahead-ray = { $who } ist noch nicht an der Reihe: Der Strahl ist darin von t = { $enter } bis t = { $exit }.
fate-ahead-point = { $who } ist noch nicht an der Reihe; der Punkt liegt darin.
fate-passed-ray = { $who } wurde ausgelassen, obwohl der Strahl darin ist, von t = { $enter } bis t = { $exit }.
fate-strayed = { $why } Besucht wurde der Knoten trotzdem.
why-missed = { $who } wird verfehlt: { $comparison }, der Austritt durch { $exit } käme also vor dem Eintritt durch { $enter }.
why-touched = { $who } wird nur in einem Punkt berührt: { $comparison }.
why-touched-origin = { $who } wird nur in einem Punkt berührt, dem Startpunkt: { $comparison }.
why-behind = { $who } liegt hinter dem Startpunkt: Der Austritt ist bei { $comparison }.
why-beside = { $who } liegt neben dem Strahl, der sich entlang { $axis } nicht bewegt: { $comparison }.
why-end = { $who } liegt hinter dem Ende des Strahls: { $comparison }.
why-full = { $who } wird nicht mehr gebraucht, denn die Suche endet davor am ersten belegten Blatt: { $comparison }.
why-elsewhere = { $who } enthält den Punkt nicht: { $comparison }.
fate-name-visited = besucht
fate-name-entered = in Arbeit
fate-name-ahead = kommt noch
fate-name-passed = ausgelassen
fate-name-strayed = abgeirrt
fate-name-missed = verfehlt
fate-name-touched = berührt
fate-name-behind = dahinter
fate-name-beside = daneben
fate-name-end = zu weit
fate-name-full = unnötig
fate-name-elsewhere = woanders

# Hinter einem Schritt mit exakten Vergleichen, den Gleitkommazahlen anders gemacht hätten.
doubles-differ = { $ulps ->
    [0] { " " }Gleitkommazahlen würden hier irren: Beide Parameter werden auf dieselbe Zahl gerundet.
    [one] { " " }Gleitkommazahlen würden hier irren: Sie legen die Parameter 1 ulp auseinander.
   *[other] { " " }Gleitkommazahlen würden hier irren: Sie legen die Parameter { $ulps } ulp auseinander.
}

heading-step = Schritt
heading-event = Ereignis
heading-node = Knoten
heading-t = t
heading-what = Was geschieht
