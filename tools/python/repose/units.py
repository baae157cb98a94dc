"""How figures are shown: names without their units' endings, in units that a person reads."""

# ending of a name, unit shown, factor from SI
UNITS = (("_kg_m3", "kg/m³", 1.0), ("_J_kg", "mJ/g", 1.0), ("_kg_s", "g/s", 1e3), ("_kg", "g", 1e3), ("_deg_s", "degrees/s", 1.0),
         ("_deg", "degrees", 1.0), ("_Nm", "N m", 1.0),
         ("_m", "mm", 1e3), ("_s", "s", 1.0), ("_J", "J", 1.0), ("_N", "N", 1.0), ("_Pa", "Pa", 1.0), ("_K", "K", 1.0))


def words(name):
    """A name of a deck without underscores and dots."""
    return name.replace("_", " ").replace(".", " ")


def display(figure):
    """Of a figure: its name, its unit ("" for counts) and the factor from SI to it: `discharged_mass_kg` is "discharged
    mass" in "g", times 1e3."""
    for ending, unit, factor in UNITS:
        if figure.endswith(ending):
            return words(figure[:-len(ending)]), unit, factor
    return words(figure), "", 1.0


def quantity(figure):
    """Name with its unit, as at an axis ("discharged mass, g"), and the factor from SI to it."""
    name, unit, factor = display(figure)
    return (f"{name}, {unit}" if unit else name), factor


def prefixed(largest, unit):
    """Factor and unit with the prefix that makes a value a number from 1 to 1000: (1e3, "mN") for 0.02 N."""
    for factor, prefix in ((1e-6, "M"), (1e-3, "k"), (1.0, ""), (1e3, "m"), (1e6, "µ"), (1e9, "n")):
        if largest * factor >= 1.0 or prefix == "n":
            return factor, prefix + unit
