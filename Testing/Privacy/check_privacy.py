"""Runs tools on a series with marked identifying attributes and searches all their output for the marks.

usage: check_privacy.py TOOL_FOLDER WORK_FOLDER [--colonoscopy]

Fails if marks are found that Documentation/privacy.md does not state. Base64, gzip and deflated data are also searched.
--colonoscopy runs VirtualColonoscopy with viewer and DICOM results; otherwise the fast tools run."""

import base64
import re
import shutil
import subprocess
import sys
import zlib
from pathlib import Path

import pydicom

TEXTS = ("PatientName", "PatientID", "PatientAddress", "PatientTelephoneNumbers", "PatientComments", "OtherPatientIDs", "AccessionNumber",
         "StudyID", "StudyDescription", "SeriesDescription", "ProtocolName", "ImageComments", "ReferringPhysicianName", "OperatorsName",
         "PerformingPhysicianName", "InstitutionName", "InstitutionAddress", "StationName", "DeviceSerialNumber")
MARKS = {name: f"QZXW7MARK{number:02}" for number, name in enumerate(TEXTS)}
MARKS["PatientBirthDate"] = "19340507"
MARKS["StudyDate"] = "19340608"
MARKS["StudyInstanceUID"] = "1.2.999.73519.1"
MARKS["SeriesInstanceUID"] = "1.2.999.73519.2"
MARKS["FrameOfReferenceUID"] = "1.2.999.73519.3"
INSTANCE = "1.2.999.73519.4"

IN_ANY_FILE = {"SeriesInstanceUID"}
IN_REPORT = {"SeriesInstanceUID", "SeriesDescription"}
IN_LISTINGS = IN_REPORT | {"PatientID", "StudyDate"}  # of DicomSeriesInspector
IN_VIEWER = {"SeriesInstanceUID", "PatientID", "StudyDate"}
IN_DICOM_RESULTS = {"PatientName", "PatientID", "PatientBirthDate", "AccessionNumber", "StudyID", "StudyDate", "StudyDescription",
                    "ReferringPhysicianName", "StudyInstanceUID", "SeriesInstanceUID", "FrameOfReferenceUID", "SOPInstanceUID"}
IN_FHIR = {"PatientID", "StudyInstanceUID", "SeriesInstanceUID", "SOPInstanceUID"}


def mark(source, target):
    target.mkdir()
    for number, path in enumerate(sorted(source.iterdir()), 1):
        data = pydicom.dcmread(path)
        for name, value in MARKS.items():
            setattr(data, name, value)
        data.SOPInstanceUID = data.file_meta.MediaStorageSOPInstanceUID = f"{INSTANCE}.{number}"
        data.save_as(target / f"slice{number:04}.dcm")


def inflated(data):
    for bits in (15, -15, 31):
        try:
            yield zlib.decompressobj(bits).decompress(data)
        except zlib.error:
            pass


def views(data):
    """Yields the bytes and their decoded content."""
    yield data
    yield data.replace(b"\0", b"")  # for UTF-16
    header_end = data.find(b"\n\n") + 2 if data.startswith(b"NRRD") else 0
    yield from inflated(data[header_end:])
    for text in re.findall(rb"[A-Za-z0-9+/]{16,}={0,2}", data):
        decoded = base64.b64decode(text[: len(text) // 4 * 4])
        yield decoded
        yield from inflated(decoded)
        yield from inflated(decoded[16:])  # VTK writes block sizes first


def marks_in(data):
    searched = {**MARKS, "SOPInstanceUID": INSTANCE + "."}
    return {name for view in views(data) for name, value in searched.items() if value.encode() in view}


def allowed_in(path):
    if path.suffix == ".dcm":
        return IN_DICOM_RESULTS
    if path.name == "fhir.json":
        return IN_FHIR
    if path.stem == "series":
        return IN_LISTINGS
    if path.parent.name == "viewer" or path.parent.parent.name == "viewer":
        return IN_VIEWER
    return IN_REPORT if path.name == "report.html" else IN_ANY_FILE


def run(tools, name, *arguments):
    result = subprocess.run([tools / name, *arguments], capture_output=True, check=False)
    if result.returncode != 0:
        sys.exit(f"{name} ended with status {result.returncode}: {result.stderr.decode()}")
    return result.stdout + result.stderr


def run_fast_tools(tools, series, out):
    (out / "series.txt").write_bytes(run(tools, "DicomSeriesInspector", series, "--json", out / "series.json"))
    (out / "image.txt").write_bytes(run(tools, "DicomSeriesToImage", series, out / "image.nrrd"))
    run(tools, "DicomSeriesToImage", series, out / "image.nii.gz", "--quiet")
    (out / "heat.txt").write_bytes(
        run(tools, "CumulativeHeatDiffusion", series, out / "heat.nrrd", "--timeSteps", "50", "--report", out / "report"))


def run_colonoscopy(tools, series, out):
    (out / "colon.txt").write_bytes(
        run(tools, "VirtualColonoscopy", series, out / "colon", "--faces", "20000", "--viewer", "--dicomResults"))
    run(tools, "ColonResultsToDicom", out / "colon", out / "objects", "--source", series, "--labelMap", "--ohif", "--fhir", "--quiet")


def main(tools, work, is_colonoscopy):
    shutil.rmtree(work, ignore_errors=True)
    out = work / "out"
    out.mkdir(parents=True)
    size = "128,128,120" if is_colonoscopy else "64,64,60"
    run(tools, "ColonPhantom", work / "phantom", "--size", size, "--seed", "7", "--quiet")
    mark(work / "phantom", work / "marked")
    (run_colonoscopy if is_colonoscopy else run_fast_tools)(tools, work / "marked", out)
    found = {path: marks_in(path.read_bytes()) for path in sorted(out.rglob("*")) if path.is_file()}
    faults = [f"{path.relative_to(out)}: {name}" for path, names in found.items() for name in sorted(names - allowed_in(path))]
    if not any(found.values()):
        faults.append("no mark was found, not even the series UID: the search is broken")
    if is_colonoscopy and "PatientName" not in found[out / "colon/dicom/sr.dcm"]:
        faults.append("DICOM results do not contain the patient name of their series")
    if faults:
        sys.exit("identifying data not stated in Documentation/privacy.md:\n" + "\n".join(faults))
    print(f"{len(found)} files contain no identifying data beyond Documentation/privacy.md")


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]), "--colonoscopy" in sys.argv[3:])
