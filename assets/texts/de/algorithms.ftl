# Texte der Tafeln, die zu einem Verfahren oder zu wenigen gehören, auf Deutsch.

panel-cuts = Schnitte
panel-children = Jedes Kind
panel-way-down = Weg von der Wurzel
panel-links = Verweise
panel-halves = Halbieren
panel-mid-planes = Mittelebenen
panel-grid = Feinstes Raster

algorithms-top-down = Von oben nach unten
algorithms-bottom-up = Von Blatt zu Blatt, von unten
algorithms-grid = Auf dem feinsten Raster
algorithms-reference = Vergleichsmaßstab

cuts-none = Zeigt die sortierten Mittelebenen, sobald ein Knoten zerschnitten wird.
cuts-middle = Mitte
cuts-mask = Vorzeichen
cuts-plane = Ebene
cuts-inside = schneidet
cuts-before = davor
cuts-after = danach
cuts-piece = Stück in t
cuts-child = Kind

children-none = Zeigt die Prüfung aller Kinder, sobald ein Knoten betreten wird.
children-order = Nr.
children-child = Kind
children-bits = Bits
children-interval = t
children-missed = verfehlt

way-down-none = Zeigt den Weg von der Wurzel, sobald ein Punkt gesucht wird.
way-down-count = Suche { $n }
way-down-level = Stufe { $level }
way-down-root = Wurzel
way-down-exit = Austritt
way-down-pushed = verschoben nach
way-down-target = Codes dahinter

tables-none = Zeigt die benutzten Einträge, sobald ein Nachbar gesucht wird.
tables-used = Richtung { $direction }, Kind { $child }.
tables-point = { " " }Wer auf einen Eintrag zeigt, liest seine Regel.
tables-used-before = Zuletzt nachgeschlagen: Richtung { $direction }, Kind { $child }.
tables-bits-before = Zuletzt aus den Bits gelesen: Richtung { $direction }, Kind { $child }.
tables-used-bits = Richtung { $direction }, Kind { $child }: aus den Bits gelesen; die Tabellen sagen dasselbe.
tables-child = Kind
tables-yes = ja
tables-up = Weg hinauf
tables-down = gespiegelt hinab
tables-down-facing = hinab
tables-step-up = von Kind { $child } zu Stufe { $level }
tables-step-down = zu Kind { $child }, Stufe { $level }
tables-all = Alle Richtungen
tables-adjacent-why = Kind { $child } hat { $bits }. Es liegt auf der Seite { $direction } seines Elternknotens, wenn sein Bit bei + eine 1 und bei − eine 0 ist.
tables-common-why = Kind { $child } hat { $bits }. Von { $direction } bleiben die Achsen, auf denen es auf dieser Seite seines Elternknotens liegt: sein Bit ist 1 bei +, 0 bei −. Dort liegt der Nachbar jenseits des Elternknotens.
tables-reflect-why = Kind { $child } hat { $bits }. Die Bits aller Achsen in { $direction } werden umgekehrt.

links-none = Zeigt die Verweise eines Blattes, sobald das erste gefunden ist.
links-side = Seite
links-size = Nachbar
links-larger = größer
links-equal = Blatt
links-divided = geteilt
links-border = Rand

mid-planes-none = Zeigt den Vergleich mit den Mittelebenen, sobald ein Kind gewählt wird.
mid-planes-point = Punkt
mid-planes-plane = Mittelebene
mid-planes-bit = Bit

halves-none = Zeigt die Ebene und ihren Parameter, sobald ein Teil halbiert wird.
halves-near = nur nahe Hälfte
halves-far = nur ferne Hälfte
halves-both = nahe, später ferne
halves-near-why = Zwischen Start und Austritt aus dem Teil trifft der Strahl die Ebene nicht.
halves-far-why = Der Strahl hat die Ebene spätestens getroffen, als er in den Teil eintrat.
halves-both-why = Der Strahl trifft die Ebene im Teil: die ferne Hälfte wartet auf dem Stapel.
halves-gem-near-why = Das Gem: t ist größer als das Ende des Teils oder kleiner als 0.
halves-gem-far-why = Das Gem: t ist kleiner als der Anfang des Teils.
halves-gem-both-why = Das Gem: t ist weder größer als das Ende des Teils noch kleiner als 0 oder sein Anfang. Die ferne Hälfte wartet auf dem Stapel.
halves-gem-nan-why = Das Gem: t ist keine Zahl, sodass kein Vergleich zutrifft. Die ferne Hälfte wartet auf dem Stapel.

grid-none = Zeigt die nächsten Ebenen, sobald die erste Zelle gefunden ist.
grid-count = { $n ->
    [one] 1 Zelle
   *[other] { $n } Zellen
}
grid-cell = Zelle
grid-outside = außerhalb
grid-crossed = durch Ebene { $axes }
