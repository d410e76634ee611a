"""De-identification: all attributes of the profile are removed from a slice, and a patient's series stay together."""

import datetime
import os
import subprocess
import unittest

try:
    import pydicom
except ImportError:
    print("skipped: python3-pydicom is not installed; see Utilities/install-dependencies workflow-pacs")
    raise SystemExit from None
from case import Case, WORKFLOW
from pydicom.datadict import dictionary_VR
from pydicom.dataset import Dataset, FileDataset, FileMetaDataset
from pydicom.sequence import Sequence
from pydicom.uid import CTImageStorage, ExplicitVRLittleEndian

PACS = os.path.join(WORKFLOW, "pacs")
VALUES = {
    "DA": "20191231", "DT": "20191231120000", "TM": "115959", "AS": "077Y", "IS": "77123", "DS": "77.123", "UI": "1.2.77.123",
    "US": 7123, "UL": 7123, "SS": 7123, "SL": 7123, "FD": 77.123, "FL": 77.5, "CS": "SECRET",
    "OB": b"secret!!", "OW": b"secret!!", "UN": b"secret!!",
}


def profile_tags():
    with open(f"{PACS}/confidential.txt", encoding="ascii") as file:
        tags = [int(line.split()[0].replace(",", ""), 16) for line in file if not line.startswith("#")]
    return [tag for tag in tags if tag >= 0x00080000]  # lower tags belong to files and messages


def fill(data):
    """A slice with every attribute of the profile supported by pydicom, also nested once, and a private one."""
    count = 0
    for tag in profile_tags():
        try:
            vr = dictionary_VR(tag).split(" ")[0]
        except KeyError:
            continue
        count += 1
        if vr == "SQ":
            inner = Dataset()
            inner.PatientComments = "secret inside"
            data.add_new(tag, vr, Sequence([inner]))
        else:
            data.add_new(tag, vr, VALUES.get(vr, f"Secret{tag:08x}"[:16]))
    data.add_new(0x00090010, "LO", "SECRET VENDOR")
    data.add_new(0x00091001, "LO", "secret of a vendor")
    data.add_new(0x60003000, "OW", b"overlay!")
    return count


class Deidentified(Case):
    def setUp(self):
        super().setUp()
        self.keys = self.write("keys", "0123456789abcdef" * 4)

    def slice(self, folder, number, **values):
        meta = FileMetaDataset()
        meta.MediaStorageSOPClassUID, meta.TransferSyntaxUID = CTImageStorage, ExplicitVRLittleEndian
        meta.MediaStorageSOPInstanceUID = f"1.2.3.{number}"
        path = self.write(f"{folder}/{number}.dcm", "")
        data = FileDataset(path, {}, file_meta=meta, preamble=b"\0" * 128)
        data.is_little_endian, data.is_implicit_VR = True, False
        self.filled = fill(data)
        data.SOPClassUID, data.SOPInstanceUID, data.Modality = CTImageStorage, f"1.2.3.{number}", "CT"
        data.SeriesInstanceUID, data.StudyInstanceUID, data.FrameOfReferenceUID = f"1.2.4.{folder}", "1.2.5", "1.2.6"
        data.PatientID, data.PatientName = "REAL-ID-77", "Real^Name"
        data.Rows = data.Columns = 2
        data.BitsAllocated, data.PixelRepresentation = 16, 0
        data.PixelData = b"\1\2\3\4\5\6\7\10"
        for keyword, value in values.items():
            setattr(data, keyword, value)
        data.save_as(path, write_like_original=False)

    def call(self, name, *arguments):
        return subprocess.run([f"{PACS}/{name}", *arguments], cwd=self.folder, capture_output=True, text=True)

    def clean(self, folder, keys=None):
        target = os.path.join(self.folder, f"clean-{folder}-{os.path.basename(keys or self.keys)}")
        result = self.call("deidentify", folder, target, keys or self.keys)
        self.assertEqual(result.returncode, 0, result.stderr)
        return [pydicom.dcmread(os.path.join(target, name)) for name in sorted(os.listdir(target))]

    def test_nothing_of_the_profile_is_left(self):
        self.slice("1", 1)
        self.assertGreater(self.filled, 500)
        before = self.call("check-deidentified", "1")
        self.assertGreater(len(before.stdout.splitlines()), 300)
        self.assertEqual(before.returncode, 1)
        self.clean("1")
        after = self.call("check-deidentified", "clean-1-keys", "1")
        self.assertEqual((after.returncode, after.stdout), (0, "1 files, 0 faults\n"))

    def test_the_check_finds_what_is_hidden(self):
        self.slice("1", 1)
        data = self.clean("1")[0]
        for keyword, value in (("ManufacturerModelName", "Real^Name"), ("ConvolutionKernel", "REAL-ID-77"), ("PatientComments", "x")):
            kept = data.get(keyword)
            setattr(data, keyword, value)
            os.makedirs(f"{self.folder}/spoilt", exist_ok=True)
            data.save_as(f"{self.folder}/spoilt/1.dcm")
            self.assertEqual(self.call("check-deidentified", "spoilt", "1").returncode, 1, keyword)
            setattr(data, keyword, kept) if kept else delattr(data, keyword)

    def test_positions_of_a_patient_stay_together(self):
        self.slice("1", 1, StudyDate="20200131", SeriesDate="20200131")
        self.slice("2", 2, StudyDate="20200131", SeriesDate="20200201")
        one, two = self.clean("1")[0], self.clean("2")[0]
        for keyword in ("PatientID", "PatientName", "StudyInstanceUID", "FrameOfReferenceUID", "StudyDate"):
            self.assertEqual(one[keyword].value, two[keyword].value, keyword)
        for keyword in ("SeriesInstanceUID", "SOPInstanceUID"):
            self.assertNotEqual(one[keyword].value, two[keyword].value, keyword)
        dates = [datetime.datetime.strptime(data.SeriesDate, "%Y%m%d") for data in (one, two)]
        self.assertEqual((dates[1] - dates[0]).days, 1)
        self.assertLess(dates[0], datetime.datetime(2019, 2, 1))
        self.assertEqual(one.PixelData, b"\1\2\3\4\5\6\7\10")

    def test_another_secret_gives_other_names_and_another_patient_too(self):
        self.slice("1", 1)
        self.slice("2", 2, PatientID="OTHER")
        other = self.write("other", "f" * 64)
        names = {self.clean("1")[0].PatientID, self.clean("1", other)[0].PatientID, self.clean("2")[0].PatientID}
        self.assertEqual(len(names), 3)

    def refused(self, words, **values):
        self.slice("1", 1, **values)
        result = self.call("deidentify", "1", "none", self.keys)
        self.assertEqual(result.returncode, 3)
        self.assertIn(words, result.stderr)
        self.assertEqual(len(result.stderr.splitlines()), 1)

    def test_refusals(self):
        self.refused("has BurnedInAnnotation YES", BurnedInAnnotation="YES")
        self.refused("has RecognizableVisualFeatures YES", RecognizableVisualFeatures="YES")
        self.refused("is not a CT slice but Secondary Capture", SOPClassUID="1.2.840.10008.5.1.4.1.1.7")
        self.keys = self.write("short", "abc")
        self.refused("contains less than 32 characters")


if __name__ == "__main__":
    unittest.main()
