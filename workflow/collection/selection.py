"""Selects the series of an examination: a supine and a prone one, or others if these are missing."""

LEAST_LENGTH = 250.0  # mm; a scan of a whole colon is longer, a topogram or a repeated part shorter
GREATEST_SPACING = 3.0  # mm between slices; thicker slices hide polyps of 6 mm
ORDER = ("supine", "prone", "leftDecubitus", "rightDecubitus")  # the first two that exist form the examination


def select(series):
    """Returns the selected series, at most two, and for each other series why it is not selected: {uid: reason}."""
    reasons, usable = {}, []
    for one in series:
        reason = fault_of(one)
        if reason:
            reasons[one.uid] = reason
        else:
            usable.append(one)
    best = {}
    for one in sorted(usable, key=rank):
        if one.position in best:
            reasons[one.uid] = f"series {best[one.position].number} has finer slices, or more"
        else:
            best[one.position] = one
    chosen = [best[position] for position in ORDER if position in best]
    for one in chosen[2:]:
        reasons[one.uid] = "an examination has two positions"
    return chosen[:2], reasons


def fault_of(one):
    """Returns why a series cannot be part of an examination, or an empty text."""
    if one.refusal:
        return one.refusal
    if one.plane != "axial":
        return f"it is {one.plane}, not axial CT"
    if one.length < LEAST_LENGTH:
        return f"it is {one.length:.0f} mm long, less than {LEAST_LENGTH:.0f} mm: a topogram or a part"
    if one.spacing > GREATEST_SPACING:
        return f"its slices are {one.spacing:.1f} mm apart, more than {GREATEST_SPACING:.0f} mm"
    if not one.position:
        return "neither its header nor its description states how the patient lies"
    return ""


def rank(one):
    """Sort key of reconstructions of one position: finer slices first, then more slices, then the first series."""
    return round(one.spacing, 2), -one.slices, one.number, one.uid
