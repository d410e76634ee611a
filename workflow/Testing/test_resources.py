"""Resources of an examination."""

import os
import unittest

from case import Case
from cohort.resources import megabytes, minutes, voxels_of


class Resources(Case):
    def test_memory_by_hand(self):
        self.assertEqual(megabytes(100_000_000, 1), 3400)
        self.assertEqual(megabytes(100_000_000, 2), 6800)
        self.assertEqual(megabytes(100_000_000, 2, 5000), 5000)
        self.assertGreater(megabytes(512 * 512 * 430, 1), 3453 + 120)  # a real series, and Snakemake

    def test_time_grows_with_voxels_and_attempts(self):
        self.assertEqual(minutes(100_000_000, 1), 70)
        self.assertEqual(minutes(100_000_000, 2), 140)

    def test_voxels_of_a_folder(self):
        self.assertEqual(voxels_of(os.path.join(self.folder, "absent")), 0)
        self.write("texts/readme.txt", "no slice")
        self.assertEqual(voxels_of(os.path.join(self.folder, "texts")), 0)
        for number in range(3):
            self.slice(f"series/{number}.dcm", 64, 32)
        self.assertEqual(voxels_of(os.path.join(self.folder, "series")), 3 * 64 * 32)

    def slice(self, name, rows, columns):
        """An explicit little-endian file of two elements, behind its file meta information."""
        def element(group, number, vr, value):
            return group.to_bytes(2, "little") + number.to_bytes(2, "little") + vr + len(value).to_bytes(2, "little") + value

        syntax = element(2, 0x10, b"UI", b"1.2.840.10008.1.2.1\0")
        meta = element(2, 0, b"UL", len(syntax).to_bytes(4, "little")) + syntax
        data = element(0x28, 0x10, b"US", rows.to_bytes(2, "little")) + element(0x28, 0x11, b"US", columns.to_bytes(2, "little"))
        with open(self.write(name, ""), "wb") as file:
            file.write(b"\0" * 128 + b"DICM" + meta + data)


if __name__ == "__main__":
    unittest.main()
