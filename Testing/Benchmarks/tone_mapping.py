"""How far tone mappings move the colors of color tables: mean and largest change in levels of 255, where a surface is fully lit.

Usage: python3 tone_mapping.py          (needs numpy and matplotlib)
Neutral and Filmic are those of Kernels/Shading/Tone.glsl. AgX: Benjamin Wrensch's fit ("Minimal AgX Implementation", 2023) of
Troy Sobotka's transform. Khronos: "Khronos PBR Neutral Tone Mapper" (2024).
"""
import matplotlib
import numpy

TABLES = ("viridis", "plasma", "coolwarm", "jet")
#: light on the surface, of which 1 makes a white one white: less than all, all, and with what others scatter onto it
LIGHTS = (0.5, 1.0, 1.3)

AGX_IN = numpy.array([[0.842479062253094, 0.0423282422610123, 0.0423756549057051],
                      [0.0784335999999992, 0.878468636469772, 0.0784336],
                      [0.0792237451477643, 0.0791661274605434, 0.879142973793104]])
AGX_OUT = numpy.array([[1.19687900512017, -0.0528968517574562, -0.0529716355144438],
                       [-0.0980208811401368, 1.15190312990417, -0.0980434501171241],
                       [-0.0990297440797205, -0.0989611768448433, 1.15107367264116]])


def to_linear(color):
    """Light of a display color (IEC 61966-2-1)."""
    return numpy.where(color <= 0.04045, color / 12.92, ((color + 0.055) / 1.055) ** 2.4)


def to_display(light):
    """Display color of light."""
    light = numpy.clip(light, 0.0, 1.0)
    return numpy.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1.0 / 2.4) - 0.055)


def filmic(light):
    """Narkowicz's fit of the ACES reference curve."""
    return light * (2.51 * light + 0.03) / (light * (2.43 * light + 0.59) + 0.14)


def compressed(light, start):
    """Light whose largest channel is above `start`, and what that channel becomes; below 1."""
    peak = light.max(axis=-1, keepdims=True)
    return peak, numpy.where(peak < start, peak, 1.0 - (1.0 - start) ** 2 / (peak + 1.0 - 2.0 * start))


def neutral(light):
    """The plugin's: all channels by one factor."""
    peak, shown = compressed(light, 0.9)
    return light * shown / numpy.maximum(peak, 1e-9)


def khronos(light):
    """With an offset for a dielectric's reflection, and bright colors turned toward white."""
    least = light.min(axis=-1, keepdims=True)
    light = light - numpy.where(least < 0.08, least - 6.25 * least * least, 0.04)
    peak, shown = compressed(light, 0.76)
    white = 1.0 - 1.0 / (0.15 * (peak - shown) + 1.0)
    return numpy.where(peak < 0.76, light, light * shown / numpy.maximum(peak, 1e-9) * (1.0 - white) + shown * white)


def agx(light):
    """Six terms of a sigmoid of the logarithm, between two matrices."""
    x = (numpy.clip(numpy.log2(numpy.maximum(light @ AGX_IN, 1e-10)), -12.47393, 4.026069) + 12.47393) / 16.499999
    x = 15.5 * x ** 6 - 40.14 * x ** 5 + 31.96 * x ** 4 - 6.868 * x ** 3 + 0.4298 * x ** 2 + 0.1191 * x - 0.00232
    return numpy.clip(x @ AGX_OUT, 0.0, 1.0) ** 2.2


def hue_change(shown, color):
    """Mean degrees between hues, of colors that have one."""
    def hue(rgb):
        opponent = rgb @ numpy.array([[1.0, 0.0], [-0.5, 3.0 ** 0.5 / 2.0], [-0.5, -(3.0 ** 0.5) / 2.0]])
        return numpy.degrees(numpy.arctan2(opponent[:, 1], opponent[:, 0])), numpy.hypot(opponent[:, 0], opponent[:, 1])
    (before, chroma), (after, _) = hue(color), hue(shown)
    return numpy.abs((after - before + 180.0) % 360.0 - 180.0)[chroma > 0.1].mean()


def main():
    """Prints one row for each tone mapping and amount of light: means over all tables."""
    tables = {name: matplotlib.colormaps[name](numpy.linspace(0.0, 1.0, 256))[:, :3] for name in TABLES}
    print("| tone mapping | light | mean change | largest | hue, degrees |")
    print("|---|---|---|---|---|")
    for name, mapping in (("None", lambda light: light), ("Neutral", neutral), ("Khronos neutral", khronos), ("Filmic", filmic),
                          ("AgX", agx)):
        for light in LIGHTS:
            changes, hues = [], []
            for table in tables.values():
                shown = to_display(mapping(to_linear(table) * light))
                # What the table's color is in that much light, if nothing clips: only what the mapping adds counts.
                wanted = to_display(to_linear(table) * min(light, 1.0))
                changes.append(numpy.abs(shown - wanted) * 255.0)
                hues.append(hue_change(shown, table))
            changes = numpy.concatenate(changes)
            print("| %s | %.1f | %.1f | %.0f | %.1f |" % (name, light, changes.mean(), changes.max(), numpy.mean(hues)))


if __name__ == "__main__":
    main()
