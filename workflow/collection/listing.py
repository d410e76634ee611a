"""Patients of a downloaded collection, and the DICOM series of each."""

import dataclasses
import json
import os
import re
import subprocess

from cohort.files import read_json, write_whole

LYING = {"S": "supine", "P": "prone", "DL": "leftDecubitus", "DR": "rightDecubitus"}  # PS3.3 C.7.3.1.1.2, after HF or FF
WORDS = {"supine": "supine", "prone": "prone", "decub left": "leftDecubitus", "decub right": "rightDecubitus"}


@dataclasses.dataclass
class Series:
    """A series of a patient; places of slices are in mm along the normal, by instance number."""

    uid: str
    number: int
    description: str
    position: str  # supine, prone, leftDecubitus, rightDecubitus, or empty
    doubt: str  # why the position may be wrong
    plane: str
    slices: int
    spacing: float  # of slices, mm
    folder: str
    refusal: str
    origin: list
    normal: list
    places: dict

    @property
    def length(self):
        return self.slices * self.spacing

    def point(self, instance):
        """Returns the position (LPS, mm) of the first pixel of a slice, or None if the series lacks it."""
        if instance not in self.places:
            return None
        return [start + self.places[instance] * step for start, step in zip(self.origin, self.normal)]


def patients_of(data):
    """Returns {subject: folder}. Folders that only contain one folder, such as that of the collection, are skipped."""
    folder = os.path.abspath(data)
    while True:
        inside = sorted(entry.name for entry in os.scandir(folder) if entry.is_dir())
        if len(inside) != 1 or any(entry.is_file() and entry.name.endswith(".dcm") for entry in os.scandir(folder)):
            break
        folder = os.path.join(folder, inside[0])
    return {re.sub("[^A-Za-z0-9_-]", "_", name): os.path.join(folder, name) for name in inside}


def read_series(tools, folder, cache):
    """Lists the series below a folder, by DicomSeriesInspector; the result is kept in the file `cache`. Returns the series
    and the reason if there is none."""
    if not os.path.exists(cache):
        temporary = f"{cache}.{os.getpid()}.json"
        done = subprocess.run(
            [os.path.join(tools, "DicomSeriesInspector"), folder, "--json", temporary], capture_output=True, text=True, check=False
        )
        if done.returncode == 0:
            os.replace(temporary, cache)
        else:
            message = (done.stderr.strip().splitlines() or ["no message"])[-1]
            write_whole(cache, json.dumps({"series": [], "message": message}) + "\n")
    document = read_json(cache)
    return [series_of(one, folder) for one in document["series"]], document.get("message", "")


def series_of(one, folder):
    """Converts an entry of the document of DicomSeriesInspector."""
    position, doubt = position_of(one["patientPosition"], one["description"])
    direction = one["direction"]
    refusal = one["refusal"]
    if not refusal and one["parts"] > 1:
        refusal = f"its images form {one['parts']} volumes"
    folders = {os.path.dirname(part["file"]) for part in one["slices"]}
    return Series(
        uid=one["seriesInstanceUID"],
        number=one["seriesNumber"] or 0,
        description=one["description"],
        position=position,
        doubt=doubt,
        plane=one["plane"] if one["modality"] == "CT" else f"{one['plane']} {one['modality']}",
        slices=one["size"][2],
        spacing=one["spacing"][2],
        folder=os.path.join(folder, folders.pop()) if len(folders) == 1 else folder,
        refusal=refusal,
        origin=one["origin"],
        normal=[direction[2], direction[5], direction[8]],
        places={part["instanceNumber"]: part["position"] for part in one["slices"]},
    )


def position_of(code, description):
    """Returns how the patient lies by the header, or else by the description, and a contradiction between them."""
    by_header = LYING.get(code[2:], "")
    text = description.lower()
    by_words = next((position for words, position in WORDS.items() if all(word in text for word in words.split())), "")
    if by_header and by_words and by_header != by_words:
        return by_header, f'the description "{description}" contradicts the position {code} of its header'
    return by_header or by_words, ""
