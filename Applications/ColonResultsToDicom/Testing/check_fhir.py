#!/usr/bin/env python3
"""check_fhir.py SERIES_FOLDER EXAM_FOLDER RESULT_FOLDER

Checks fhir.json of ColonResultsToDicom, for the verdicts of MakeVerdicts.cmake: the study against the DICOM files, the
candidates against candidates.csv, the reader's report against the verdicts, and all references.
"""

import csv
import json
import pathlib
import re
import sys

import check_objects
import pydicom
from check_objects import check

UID_SYSTEM = "urn:dicom:uid"
DCM = "http://dicom.nema.org/resources/ontology/DCM"


def of_type(bundle, kind):
    return [entry["resource"] for entry in bundle["entry"] if entry["resource"]["resourceType"] == kind]


def references(value):
    if isinstance(value, dict):
        if "reference" in value:
            yield value["reference"]
        for member in value.values():
            yield from references(member)
    elif isinstance(value, list):
        for member in value:
            yield from references(member)


def check_references(bundle):
    urls = [entry["fullUrl"] for entry in bundle["entry"]]
    form = re.compile(r"urn:uuid:[0-9a-f]{8}-[0-9a-f]{4}-8[0-9a-f]{3}-8[0-9a-f]{3}-[0-9a-f]{12}")
    check(all(form.fullmatch(url) for url in urls), "every URL is a UUID")
    check(len(set(urls)) == len(urls), "every URL is unique")
    check(set(references(bundle)) <= set(urls), "every reference is in the bundle")


def check_study(study, series, folder):
    """Every file is an instance of the study, and nothing else is."""
    files = [pydicom.dcmread(path, stop_before_pixels=True) for path in (*series.glob("*.dcm"), *folder.glob("*.dcm"))]
    written = {(f.SeriesInstanceUID, f.Modality, f.SOPInstanceUID, "urn:oid:" + f.SOPClassUID) for f in files}
    stated = {
        (one["uid"], one["modality"]["code"], instance["uid"], instance["sopClass"]["code"])
        for one in study["series"]
        for instance in one["instance"]
    }
    check(stated == written, "the study lists the files")
    check(study["numberOfInstances"] == len(files), "number of instances")
    check(study["numberOfSeries"] == len({f.SeriesInstanceUID for f in files}), "number of series")
    check(study["identifier"] == [{"system": UID_SYSTEM, "value": "urn:oid:" + files[0].StudyInstanceUID}], "study UID")


def number_of(observation, text):
    return next(c["valueQuantity"]["value"] for c in observation["component"] if c["code"]["text"] == text)


def check_candidates(observations, rows):
    check(len(observations) == len(rows) > 0, f"{len(observations)} observations of {len(rows)} candidates")
    for observation, row in zip(observations, rows):
        name = "candidate " + row["candidate"]
        check(observation["code"]["text"] == name, f"{name}: name")
        check(observation["status"] == "preliminary", f"{name}: status")
        check("device" in observation and "performer" not in observation, f"{name}: of a device")
        for text, column, factor in (
            ("Diameter, Maximum", "diameter", 1.0),
            ("Height", "height", 1.0),
            ("Certainty of Finding", "score", 100.0),
            ("Distance from anus", "arcLength", 1.0),
        ):
            expected = factor * float(row[column])
            check(abs(number_of(observation, text) - expected) <= 2e-4 * max(1.0, abs(expected)), f"{name}: {column}")
        site = observation["bodySite"]["text"].lower()
        check(site.startswith(row["segment"].split()[0]), f"{name}: site {site}, segment {row['segment']}")
        check(any("not a finding of a reader" in note["text"] for note in observation["note"]), f"{name}: note")


def check_reader(report, observations):
    check(report["performer"] == [{"display": "Müller^Anna"}], "reader: name")
    code = {"system": DCM, "code": "112243", "display": "C3 - Polyp, Possibly Advanced Adenoma"}
    check([c["coding"] for c in report["conclusionCode"]] == [[code]], "reader: category")
    check([o["code"]["text"] for o in observations] == ["candidate 1", "finding F1"], "reader: polyps")
    check(number_of(observations[0], "Polyp size, largest dimension") == 12.5, "reader: size")
    check(all("device" not in o for o in observations), "reader: not of a device")


def main(series, exam, folder):
    bundle = json.loads((folder / "fhir.json").read_text(encoding="utf-8"))
    check((bundle["resourceType"], bundle["type"]) == ("Bundle", "collection"), "a collection")
    check_references(bundle)
    source = pydicom.dcmread(next(series.glob("*.dcm")), stop_before_pixels=True)
    patient = {"resourceType": "Patient", "identifier": [{"value": source.PatientID}]}
    check(of_type(bundle, "Patient") == [patient], "the patient has only an identifier")
    check(str(source.PatientName) not in json.dumps(bundle, ensure_ascii=False), "the name of the patient is not stated")
    check_study(of_type(bundle, "ImagingStudy")[0], series, folder)
    resources = {entry["fullUrl"]: entry["resource"] for entry in bundle["entry"]}
    program, reader = of_type(bundle, "DiagnosticReport")
    for report in (program, reader):
        check(report["conclusion"].startswith("For research use; not a diagnosis."), "the conclusion states that it is not a diagnosis")
        check((report["status"], report["code"]["coding"][0]["code"]) == ("partial", "25045-6"), "report: status, code")
    check("conclusionCode" not in program, "the program decides no category")
    with open(exam / "polyps" / "candidates.csv", encoding="utf-8") as table:
        rows = list(csv.DictReader(table))
    results = {id(report): [resources[r["reference"]] for r in report["result"]] for report in (program, reader)}
    check(f"\n{len(rows)} candidates of a program, not findings of a reader" in program["conclusion"], "number in words")
    check_candidates(results[id(program)], rows)
    check_reader(reader, results[id(reader)])
    check(len(of_type(bundle, "Observation")) == sum(map(len, results.values())), "every observation is a result")
    return 1 if check_objects.failures else 0


if __name__ == "__main__":
    if len(sys.argv) != 4 or "--help" in sys.argv:
        print(__doc__)
        sys.exit(0 if "--help" in sys.argv else 2)
    sys.exit(main(*(pathlib.Path(argument) for argument in sys.argv[1:])))
