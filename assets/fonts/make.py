"""Subset of a font with the glyphs of this program, as TrueType with tabular digits.

    python3 make.py SOURCE.otf TARGET.ttf
"""

import sys

from fontTools import subset
from fontTools.pens.cu2quPen import Cu2QuPen
from fontTools.pens.ttGlyphPen import TTGlyphPen
from fontTools.ttLib import TTFont, newTable

RANGES = [
    (0x20, 0x7E), (0xA0, 0xFF), (0x100, 0x17F), (0x1D62, 0x1D6A),
    (0x2010, 0x2015), (0x2018, 0x201E), (0x2070, 0x209C),
    (0x2150, 0x215E), (0x2190, 0x2199),
]
SINGLE = (
    "ℓΔΣΩαβγδεθλμπσφω ‖†‡•…‰′″‹›⁄€™"
    "↩↪↻↺⇒⇐⇔⇧⌘⌥⌫⏎␣↵"
    "∀∂∃∅∆∈∉∏∑−∓∕∗∘∙√∝∞∠∥∧∨∩∪∫≈≠≡≤≥≪≫⊂⊃⊆⊇⊕⊗⊥⋅⋯⌈⌉⌊⌋⟨⟩"
    "✓✗✕✔✘○●◐◑◦◆◇■□▪▫▲△▶▷▸▹►▼▽◀◁◂◃⏮⏭⏵⏸⏹★☆☰⚠⛶"
)
WANTED = {code for low, high in RANGES for code in range(low, high + 1)} | set(map(ord, SINGLE))
# Of these ranges some places are empty in Unicode.
EMPTY = {0x2072, 0x2073, 0x208F}


def main(source: str, target: str) -> None:
    font = TTFont(source)
    freeze_tabular_digits(font)
    missing = sorted(WANTED - EMPTY - set(font.getBestCmap()))
    print(target, "lacks", " ".join(f"{chr(code)}" for code in missing))

    options = subset.Options()
    options.layout_features = ["kern", "ccmp", "mark", "mkmk", "locl"]
    options.name_IDs = [0, 1, 2, 3, 4, 5, 6, 13, 14, 16, 17]
    options.hinting = False
    options.notdef_outline = True
    subsetter = subset.Subsetter(options)
    subsetter.populate(unicodes=WANTED)
    subsetter.subset(font)
    name_family(font)
    if "CFF " in font:
        use_quadratic_outlines(font)
    font.save(target)


def freeze_tabular_digits(font: TTFont) -> None:
    """Lets characters stand for what the feature `tnum` replaces them with."""
    if "GSUB" not in font:
        return
    gsub = font["GSUB"].table
    lookups = {
        index
        for record in gsub.FeatureList.FeatureRecord
        if record.FeatureTag == "tnum"
        for index in record.Feature.LookupListIndex
    }
    replaced = {}
    for index in sorted(lookups):
        for table in gsub.LookupList.Lookup[index].SubTable:
            table = getattr(table, "ExtSubTable", table)
            replaced.update(getattr(table, "mapping", {}))
    for table in font["cmap"].tables:
        for code in set(map(ord, "0123456789")) & set(table.cmap):
            table.cmap[code] = replaced.get(table.cmap[code], table.cmap[code])
    # Interpolated weights differ by a few units in the width of digits.
    cmap = font.getBestCmap()
    digits = [cmap[ord(digit)] for digit in "0123456789"]
    width = max(font["hmtx"][digit][0] for digit in digits)
    for digit in digits:
        font["hmtx"][digit] = (width, font["hmtx"][digit][1])


def name_family(font: TTFont) -> None:
    """One family name for all weights, so that a weight can be asked for."""
    names = font["name"]
    family = "JetBrains Mono" if "Mono" in names.getDebugName(1) else "Inter"
    weight = {400: "Regular", 600: "SemiBold", 700: "Bold"}[font["OS/2"].usWeightClass]
    names.names = [n for n in names.names if n.nameID not in (16, 17)]
    for identifier, text in ((16, family), (17, weight)):
        names.setName(text, identifier, 3, 1, 0x409)


def use_quadratic_outlines(font: TTFont) -> None:
    """Cubic outlines (CFF) to quadratic ones (glyf), within a thousandth of an em."""
    order, glyphs = font.getGlyphOrder(), font.getGlyphSet()
    outlines = {}
    for name in order:
        pen = TTGlyphPen(glyphs)
        glyphs[name].draw(Cu2QuPen(pen, font["head"].unitsPerEm / 1000, reverse_direction=True))
        outlines[name] = pen.glyph()
    font["loca"] = newTable("loca")
    font["glyf"] = glyf = newTable("glyf")
    glyf.glyphOrder, glyf.glyphs = order, outlines
    for name in order:
        outlines[name].recalcBounds(glyf)
        advance = font["hmtx"][name][0]
        font["hmtx"][name] = (advance, getattr(outlines[name], "xMin", 0))
    maxp = font["maxp"]
    maxp.tableVersion = 0x00010000
    for field in (
        "maxTwilightPoints maxStorage maxFunctionDefs maxInstructionDefs maxStackElements "
        "maxSizeOfInstructions maxPoints maxContours maxCompositePoints maxCompositeContours "
        "maxComponentElements maxComponentDepth"
    ).split():
        setattr(maxp, field, 0)
    maxp.maxZones = 1
    font["post"].formatType = 3
    for tag in ("CFF ", "VORG"):
        if tag in font:
            del font[tag]
    font.sfntVersion = "\x00\x01\x00\x00"


main(*sys.argv[1:])
