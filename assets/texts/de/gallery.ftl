# Entartete Strahlen: wie sie heißen, worauf bei ihnen zu achten ist, und wie ein
# Strahl zu einem wird.

gallery-axis-parallel = Parallel zu einer Achse
watch-axis-parallel = Die anderen Achsen spielen nie mit: Ihre Parameter sind −∞ und ∞, und keine ihrer Ebenen wird je gekreuzt.
gallery-face-plane = In der Ebene einer Fläche
watch-face-plane = Jede Zelle besitzt ihre untere Ebene, also läuft der Strahl nur durch die oberen Nachbarn, und kein Blatt wird zweimal besucht.
gallery-lower-face = In der unteren Fläche der Wurzel
watch-lower-face = Die Wurzel besitzt ihre untere Fläche: Der Strahl ist drinnen, obwohl er nur an der Oberfläche entlanggleitet.
gallery-upper-face = In der oberen Fläche der Wurzel
watch-upper-face = Die Wurzel besitzt ihre obere Fläche nicht: Der Strahl geht vorbei, ohne etwas zu berühren.
gallery-edge = Entlang einer Kante
watch-edge = Vier Zellen teilen sich die Kante; ihr Besitzer liegt in beiden Achsen oben, und nur er wird besucht.
gallery-corner = Durch eine Ecke
watch-corner = Alle Ebenen der Ecke werden zugleich gekreuzt: Das nächste Blatt liegt schräg gegenüber, die dazwischen werden nur berührt.
gallery-centre = Durch die Mitte
watch-centre = Alle Mittelebenen der Wurzel werden beim selben t getroffen: Der Automat geht vom Zustand 0 geradewegs in den letzten.
gallery-diagonal = Die Hauptdiagonale hinunter
watch-diagonal = In der Spiegelmaske stehen alle Bits: Die Zustände sind die der steigenden Diagonale, die Kinder werden vom anderen Ende gezählt.
gallery-negative-zero = Eine Komponente −0
watch-negative-zero = Minus null zählt als null: Wer durch sie teilt, bekommt Unendlich mit falschem Vorzeichen, oder 0/0 in der Ebene, in der der Strahl liegt.
gallery-tiny = Eine Komponente von 10⁻⁷
watch-tiny = Die Parameter der langsamen Achse sind um sieben Größenordnungen größer: Der Strahl beginnt auf einer Ebene und verlässt sie sofort, ist also nicht parallel.
gallery-on-face = Startpunkt auf einer Fläche
watch-on-face = Der Startpunkt gehört der oberen Zelle, aber der Strahl läuft abwärts: Das erste Blatt ist das untere.
gallery-on-corner = Startpunkt auf einer Ecke
watch-on-corner = Nur eine der Zellen um den Startpunkt liegt vor dem Strahl: Die Vorzeichen der Richtung sagen, welche.
gallery-inside = Startpunkt in der Wurzel
watch-inside = Nahe Ebenen liegen hinter dem Startpunkt, mit t unter 0: Das erste Blatt wird bei t = 0 betreten.
gallery-behind = Die Wurzel liegt dahinter
watch-behind = Die Gerade trifft die Wurzel, aber nur für t unter 0: Der Strahl geht vorbei.
gallery-leaving = Sofort hinaus
watch-leaving = Der Startpunkt liegt in der unteren Fläche der Wurzel, und der Strahl läuft nach außen: Drinnen ist er für keine Länge.
gallery-grazing = Die Wurzel gestreift
watch-grazing = Der Strahl trifft die Wurzel in einem einzigen Punkt: Eintritt und Austritt sind gleich, also wird kein Blatt besucht.
gallery-miss = An der Wurzel vorbei
watch-miss = Die letzte nahe Ebene kommt nach der ersten fernen: Nie ist der Strahl zwischen allen Ebenen zugleich.
gallery-lattice = Gleichstand zweier Achsen
watch-lattice = Eine Achse steigt, eine fällt, und beide erreichen ihre Ebenen beim selben t: Beide Bits ändern sich in einem Schritt.
gallery-lattice-space = Gleichstand dreier Achsen
watch-lattice-space = Drei Ebenen werden beim selben t mit drei verschiedenen Steigungen gekreuzt: Der Schritt führt in das Blatt jenseits der Ecke.
gallery-thirds = Gerundete Drittel
watch-thirds = Die Richtung ist ein gerundetes Drittel eines Gittervektors: Gleitkommazahlen finden falsche Gleichstände oder übersehen echte, exakte Vergleiche nicht.
gallery-far = Aus einer Million Seiten Entfernung
watch-far = Die Entfernung kostet t die meisten Stellen: Gleitkommazahlen verlören kleine Zellen, also wird so weit draußen immer exakt verglichen.
gallery-slow = Fast ohne Geschwindigkeit
watch-slow = t hat die Größenordnung 10³⁰⁰: Nichts darf quadriert oder mit einer festen Toleranz verglichen werden.
gallery-none = In diesem Baum sind die Zahlen eines solchen Strahls keine Gleitkommazahlen.

snap-zero-component = Die kleinste Komponente der Richtung ist jetzt 0: Entlang dieser Achse wird nichts mehr gekreuzt.
snap-axis-parallel = Der Strahl ist jetzt parallel zu einer Achse.
snap-diagonal = Die Komponenten der Richtung sind jetzt gleich: Die Ebenen werden im Gleichschritt getroffen.
snap-through-corner = Der Strahl trifft jetzt eine Ecke genau, bei t = 1.
snap-origin-on-plane = Der Startpunkt liegt jetzt auf einer Ebene des Baums: Die Richtung sagt, auf welcher Seite.
snap-origin-on-corner = Der Startpunkt ist jetzt eine Ecke des Baums: Die Vorzeichen der Richtung sagen, welches Blatt zählt.
