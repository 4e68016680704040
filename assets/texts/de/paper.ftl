# Errata zu „Ray Tracing mit Octrees“: was gedruckt ist, was richtig ist und warum.

erratum-b-1-title = Intervall des Strahls in einem Knoten
erratum-b-1-printed = t_min = min(t_x0, t_y0), t_max = max(t_x1, t_y1)
erratum-b-1-right = t_min = max(t_x0, t_y0), t_max = min(t_x1, t_y1)
erratum-b-1-why = Der Strahl ist im Knoten, solange er auf jeder Achse zwischen den Ebenen liegt: Die Intervalle müssen sich überschneiden. Wie gedruckt trifft jeder Strahl mit d > 0.

erratum-b-2-title = Tabelle 2: Bits des ersten Kindes
erratum-b-2-printed = t_xm < t_z0 setzt Bit 0, t_zm setzt Bit 2
erratum-b-2-right = x setzt Bit 2, y Bit 1, z Bit 0
erratum-b-2-why = In Tabelle 3 und der Maske a = 4a_x + 2a_y + a_z ist x das höchste Bit. Mit vertauschten Bits beginnt der Weg im falschen Kind. Als x + 2y + 4z gelesen (B-2-morton), beginnt er im richtigen, aber dann führen Tabelle und Maske in die Irre.
reading-b-2 = wie gedruckt
reading-b-2-morton = Zustände als x + 2y + 4z gelesen

erratum-b-3-title = Auswahl der Kinder in der Ebene
erratum-b-3-printed = q_1 in beiden Zweigen; q_3, wenn t_ym < t_y1; nichts für t_xm = t_ym
erratum-b-3-right = q_2, wenn t_xm < t_ym; dann q_3, wenn t_ym < t_x1; q_0 und q_3, wenn t_xm = t_ym
erratum-b-3-why = Im zweiten Zweig ist q_1 die falsche Zelle, denn der Strahl ist entlang y in der unteren Hälfte, und t_ym < t_y1 gilt immer, also wird q_3 immer gemeldet. Ein Strahl durch die Mitte erhält gar kein Kind.

erratum-b-4-title = Parameter der Mittelebene
erratum-b-4-printed = t_xm = (t_x0 + t_x) / 2, für jedes Kind berechnet
erratum-b-4-right = t_xm = (t_x0 + t_x1) / 2, einmal für jeden Elternknoten berechnet
erratum-b-4-why = Der Index 1 fehlt. Als t_x0 gelesen fällt die Mittelebene auf die nahe Ebene. Alle Kinder eines Knotens teilen sich die zwei (drei) Werte.

erratum-b-5-title = Division durch null auf einer Ebene
erratum-b-5-printed = x / 0 = ∞ für x > 0 und −∞ für x < 0; x = 0 fehlt
erratum-b-5-right = x / 0 = −∞ auch für x = 0
erratum-b-5-why = Einer Zelle gehört ihre untere Ebene. Mit 0 / 0 = NaN gilt kein Vergleich, und ein Strahl in der oberen Seite der Wurzel zählt als Treffer.

erratum-b-6-title = Mittelebene einer Achse ohne Bewegung
erratum-b-6-printed = Gl. 15 braucht x_0 und x_1, die eine Rekursion nur über Parameter nicht mitführt
erratum-b-6-right = t_xm = ∞ für p_x unterhalb der Mittelebene, sonst −∞
erratum-b-6-why = Gl. 13 allein ergibt −∞ + ∞ = NaN, kein Vergleich gilt, und der Strahl landet in den unteren Hälften. Der Quader des Knotens muss mitgeführt werden.

erratum-b-7-title = Gespiegelter Startpunkt
erratum-b-7-printed = p' = s − p
erratum-b-7-right = p' = x_0 + x_1 − p
erratum-b-7-why = Gespiegelt wird an der Ebene durch die Mitte der Wurzel. s − p mit der Seite s der Wurzel ist nur dann dasselbe, wenn ihre Minimum-Ecke bei 0 liegt.

erratum-b-8-title = Wörter der Spiegelung
erratum-b-8-printed = An der e-Achse gespiegelt; Bildbereich; unnummeriert
erratum-b-8-right = An der Mittelebene senkrecht zu e gespiegelt; Liste der Werte f(0) … f(7); umnummeriert
erratum-b-8-why = Nur die Koordinate entlang e ändert sich. Die Zahlen selbst stimmen.

erratum-b-9-title = Kind 7 als erstes
erratum-b-9-printed = Jedes Kind außer 7 kann das erste sein
erratum-b-9-right = Gilt für Startpunkte außerhalb; von innen kann auch Kind 7 das erste sein: Eintritt = max(t_x0, t_y0, t_z0, 0)
erratum-b-9-why = Ohne die 0 beginnt der Weg bei den nahen Ebenen hinter dem Startpunkt und muss Kinder überspringen, bis er zu 7 kommt.

erratum-b-10-title = Der Strahl beginnt bei t = 0
erratum-b-10-printed = t_min < t_max allein ist ein Treffer
erratum-b-10-right = t_min < t_max und t_max > 0; Kinder mit t_1 < 0 werden übersprungen
erratum-b-10-why = Auch für eine Wurzel hinter dem Startpunkt gilt t_min < t_max. Knoten hinter dem Startpunkt würden gemeldet.

erratum-b-11-title = Abgeschlossene oder halboffene Zellen
erratum-b-11-printed = ≤ in manchen Formeln, < in anderen
erratum-b-11-right = Überall x_0 ≤ x < x_1 und t_min < t_max
erratum-b-11-why = Mit ≤ teilen sich Nachbarn Punkte, und ein Strahl, der nur eine Ecke der Wurzel berührt, ist ein Treffer.

erratum-b-12-title = Richtungen mit einer Null
erratum-b-12-printed = An einer Stelle d ≥ 0, an einer anderen d > 0
erratum-b-12-right = d > 0 bis zum Abschnitt über Nullen, danach d ≥ 0
erratum-b-12-why = Gl. 5 teilt durch d. Die Richtung muss nicht normiert sein: t ist dann keine Länge, aber die Reihenfolge bleibt.

erratum-b-13-title = Eintrittspunkt
erratum-b-13-printed = Eintrittspunkt t_0 = (t_x0, t_y0)
erratum-b-13-right = Zwei Parameter von Ebenen; der Eintritt liegt bei max(t_x0, t_y0)
erratum-b-13-why = Ein Punkt hat Koordinaten. Hier stehen zwei Werte von t, und beim späteren kommt der Strahl hinein.

erratum-b-14-title = Ein Verweis auf Formeln
erratum-b-14-printed = (4) in (5) eingesetzt
erratum-b-14-right = (5) in (6) eingesetzt
erratum-b-14-why = Die Parameter aus Gl. 5 gehören in die Bedingung von Gl. 6.

erratum-b-15-title = Noch ein Verweis
erratum-b-15-printed = Folgt aus (2); t_x1(k) ohne den Strahl
erratum-b-15-right = Folgt aus (3); t_x1(k, r)
erratum-b-15-why = Die Bedingung an die Parameter steht in Gl. 3, und ein Parameter gehört zu Knoten und Strahl.

erratum-b-16-title = Reihenfolge der Schritte
erratum-b-16-printed = Erst Gl. 11 prüfen, dann die Parameter berechnen
erratum-b-16-right = Erst berechnen, dann prüfen; Kinder in der Reihenfolge des Strahls
erratum-b-16-why = Ein Vergleich braucht zuerst seine Operanden. Schlägt er fehl, verfehlt der Strahl den Knoten, nicht den ganzen Octree.

erratum-b-17-title = Gleichstände in den Tabellen 1 und 3
erratum-b-17-printed = Nichts über zwei gleiche Austrittsparameter
erratum-b-17-right = Die Bits aller Achsen mit dem kleinsten Parameter setzen
erratum-b-17-why = Die Tabellen stimmen. Achse für Achse führt der Weg auch durch Zellen, die der Strahl nur berührt.

erratum-b-18-title = Welches Bit zuerst kommt
erratum-b-18-printed = Codes im Format „least significant bit first“
erratum-b-18-right = Gewöhnliche Binärzahlen; das Bit der obersten Verzweigung wird zuerst benutzt
erratum-b-18-why = Nur die Nummern der Bits beginnen rechts. 001000 von rechts gelesen ist 000100, eine andere Zelle.

erratum-b-19-title = Bit einer Stufe
erratum-b-19-printed = Auf Stufe k wird Bit k benutzt
erratum-b-19-right = In einem Knoten der Stufe k wird Bit k − 1 jedes Codes benutzt
erratum-b-19-why = Bit k gibt den Weg von Stufe k + 1 zu Stufe k an. Bit R jedes Codes ist 0, also ginge der erste Schritt immer in die untere Hälfte.

erratum-b-20-title = Stufe 0 und die Zahl der Bits
erratum-b-20-printed = Blätter bilden Stufe 0; so viele Bits wie Stufen
erratum-b-20-right = Stufe 0 hat die kleinsten möglichen Zellen; Blätter liegen auf jeder Stufe; N Stufen sind N − 1 Verzweigungen
erratum-b-20-why = Das oberste Bit eines Codes ist immer 0. Normiert wird das Gebiet, nicht die Werte der Knoten.

erratum-b-21-title = Koordinate 1,0
erratum-b-21-printed = Punkte in [0..1]
erratum-b-21-right = Punkte in [0, 1)
erratum-b-21-why = Bei sechs Stufen hat 1,0 den Code 100000. Alle benutzten Bits sind 0, also landet der Punkt stillschweigend in der Zelle ganz links.

erratum-b-22-title = Gesparte Vergleiche
erratum-b-22-printed = Zwei je Stufe beim Quadtree, vier beim Octree
erratum-b-22-right = Zwei beim Quadtree, drei beim Octree
erratum-b-22-why = Ein Vergleich je Achse. Von Stufe 7 bis 0 sind das 7 · 3 = 21 Vergleiche und 8 Blattprüfungen.

erratum-b-23-title = Ecke, die der Code beschreibt
erratum-b-23-printed = Linke obere Ecke
erratum-b-23-right = Minimum-Ecke: links, unten, hinten
erratum-b-23-why = Zeigt y nach oben, liegen die kleinsten Koordinaten unten.

erratum-b-24-title = Suche eines Bereichs
erratum-b-24-printed = Stufe = Nummer der ersten gemeinsamen Eins; Abstieg mit den XOR-Codes
erratum-b-24-right = Stufe = Nummer der höchsten Eins in irgendeinem XOR-Code + 1; Abstieg mit den Codes eines Punktes des Bereichs
erratum-b-24-why = Bit k trennt Zellen unterhalb von Stufe k + 1. Eine Achse genügt, um die Ecken zu trennen, und ein Unterschied sagt nichts über den Ort. Lauter Nullen bedeuten Stufe 0.
reading-b-24a = die Stufe ist die Nummer des Bits selbst
reading-b-24b = es zählt die erste Eins, die alle Differenzen gemeinsam haben
reading-b-24c = Abstieg mit den Differenzen

erratum-b-25-title = Gemeinsamer Vorfahr
erratum-b-25-printed = Aufsteigen, bis die erste Binärstelle im Abstandscode null ist
erratum-b-25-right = Aufsteigen, bis das Bit der jeweiligen Stufe null ist, ab der Stufe der Zelle
erratum-b-25-why = Die verschiedenen Bits bilden eine Kette ab der Stufe der Zelle aufwärts. Die Stelle ganz links ist immer 0, man steigt also nie auf. Die ganz rechts ändert sich nie: Ist sie 1, steigt man bis zur Wurzel.
reading-b-25-leftmost = es zählt die Stelle ganz links
reading-b-25-rightmost = es zählt die Stelle ganz rechts

erratum-b-26-title = Was HERO prüft
erratum-b-26-printed = HERO prüft alle möglichen Kindknoten nacheinander
erratum-b-26-right = HERO erzeugt nur die Kinder auf dem Strahl, in ihrer Reihenfolge
erratum-b-26-why = Maske und sortierte Mittelebenen ergeben sofort die Reihenfolge. Alle Kinder zu prüfen ist das einfache Verfahren aus Abschnitt 4.1.

erratum-b-27-title = Bottom-up und top-down
erratum-b-27-printed = Sam, SamC, SamN sind top-down, Gar ist bottom-up
erratum-b-27-right = Sam, SamC, SamN sind bottom-up, Gar ist top-down
erratum-b-27-why = Samets Verfahren steigen vom Blatt zu dessen Nachbarn auf. Gargantinis beginnt an der Wurzel und braucht keine Nachbarn.

erratum-b-28-title = Code des unteren Nachbarn
erratum-b-28-printed = Nach beiden Seiten um die Seitenlänge verschieden
erratum-b-28-right = Obere Seite: Code + Seitenlänge; untere Seite: Code − 1; außerhalb von 0 … 2^R − 1 gibt es keinen
erratum-b-28-why = Die Größe jenseits ist unbekannt, aber die kleinste Zelle an der Seite liegt in jedem Nachbarn. Ein Schritt um die Seitenlänge überspringt kleinere.

erratum-b-29-title = Erstes Blatt mit Inhalt
erratum-b-29-printed = Das erste nicht leere Blatt enthält den Treffer
erratum-b-29-right = Weitergehen, bis ein Treffer zwischen Ein- und Austritt seines Blattes liegt
erratum-b-29-why = Ein Objekt in einem Blatt kann verfehlt werden oder außerhalb dieses Blattes getroffen werden, hinter einem anderen Objekt.

erratum-b-30-title = Eltern und Kinder
erratum-b-30-printed = Jeder Knoten hat Elternknoten und Kinder
erratum-b-30-right = Alle außer der Wurzel haben Eltern, alle außer den Blättern Kinder
erratum-b-30-why = An der Wurzel beginnt der Weg nach unten, an Blättern endet er.

erratum-b-31-title = Wo die Punktsuche endet
erratum-b-31-printed = Auf der untersten Stufe
erratum-b-31-right = An einem Blatt auf beliebiger Stufe; verglichen werden die Mittelebenen
erratum-b-31-why = Große Blätter liegen oberhalb der untersten Stufe.

erratum-b-32-title = Teile des Aufsatzes
erratum-b-32-printed = Drei Kapitel, ein zweiter und ein letzter Teil
erratum-b-32-right = Die Abschnitte, wie sie nummeriert sind
erratum-b-32-why = Die Worte der Einleitung passen nicht zu den Abschnitten.

erratum-b-33-title = Strahlverfolgung mit Codes
erratum-b-33-printed = Kein Wort dazu, woher die nächsten Codes kommen
erratum-b-33-right = Aus Code und Seitenlänge des Blattes selbst
erratum-b-33-why = Das ist der Kern des Berichts: weder ein Gang in kleinsten Schritten noch ein Stapel.

erratum-b-34-title = Buchstaben für einen Knoten
erratum-b-34-printed = k im Text, o in Tabelle 2, q in der Regel für die Ebene
erratum-b-34-right = Ein Buchstabe für eine Sache
erratum-b-34-why = Alle drei sind Knoten.

erratum-b-35-title = Literaturangaben
erratum-b-35-printed = Mehrere Namen, Jahre und Titel
erratum-b-35-right = Frisken, S. F.; Lastra, M.; Havran 1999; Amanatides; Endl und Sommer 1994; Gargantini
erratum-b-35-why = Sie wurden fehlerhaft übernommen; eine zitierte Arbeit fehlt in der Liste.

erratum-b-36-title = Vergleich mit dem BSP-Baum
erratum-b-36-printed = Die Erklärung steht als Tatsache da
erratum-b-36-right = Sie stammt von den Autoren selbst; Havran nennt den Vergleich unfair
erratum-b-36-why = Eine einzige Art regelmäßiger Szenen begünstigt regelmäßige Strukturen.

erratum-b-37-title = Tempo von Gargantinis Verfahren
erratum-b-37-printed = Etwa gleich schnell wie Samets
erratum-b-37-right = In Havrans eigenen Messungen war Samets Verfahren schneller
erratum-b-37-why = Welches Verfahren gewinnt, hängt von Rechner und Programm ab.
