#!/usr/bin/python3
"""usage: random-walker.py [--beta B] [--tol T] [--times FILE] [--probabilities] IMAGE SEEDS OUT [SEEDS OUT]...

Segments a volume from seeds with scikit-image's random_walker, mode cg_j: the peer in the validation of seeded heat. OUT is the
label map of SEEDS, or with --probabilities a folder for probability1.nii etc. Seed images are processed in parallel on all
processors. FILE receives one line per seed image: CPU seconds, and 1 if the solver converged, else 0. Status 77 if
python3-skimage is not installed.
"""
import argparse
import os
import sys
import time
import warnings
from concurrent.futures import ProcessPoolExecutor

os.environ["OPENBLAS_NUM_THREADS"] = "1"  # waiting threads would count as CPU time

try:
    import nibabel
    import numpy
    from skimage.segmentation import random_walker
except ImportError as missing:
    print(f"random-walker.py: {missing}; install python3-skimage and python3-nibabel", file=sys.stderr)
    sys.exit(77)


def segment(options, seeds_path, out_path):
    """Runs one segmentation; returns CPU seconds and whether it converged."""
    image = nibabel.load(options.image)
    volume = image.get_fdata()
    seeds = numpy.asarray(nibabel.load(seeds_path).dataobj).astype(numpy.int32)
    spacing = numpy.array(image.header.get_zooms()[:3])
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        start = time.process_time()
        result = random_walker(volume, seeds, beta=options.beta, mode="cg_j", tol=options.tol,
                               return_full_prob=options.probabilities, spacing=spacing / spacing.min())
        seconds = time.process_time() - start
    if options.probabilities:
        for label, probability in enumerate(result, start=1):
            write(probability.astype(numpy.float32), image, os.path.join(out_path, f"probability{label}.nii"))
    else:
        write(result.astype(numpy.uint16), image, out_path)
    return seconds, not any("convergence" in str(warning.message) for warning in caught)


def write(array, image, path):
    """Writes an array with the geometry of the image."""
    header = image.header.copy()
    header.set_data_dtype(array.dtype)
    nibabel.Nifti1Image(array, image.affine, header).to_filename(path)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--beta", type=float, default=130)
    parser.add_argument("--tol", type=float, default=1e-3)
    parser.add_argument("--times")
    parser.add_argument("--probabilities", action="store_true")
    parser.add_argument("image")
    parser.add_argument("pairs", nargs="+")
    options = parser.parse_args()
    seeds, outs = options.pairs[::2], options.pairs[1::2]
    with ProcessPoolExecutor(os.cpu_count()) as pool:
        times = list(pool.map(segment, [options] * len(seeds), seeds, outs))
    if options.times:
        with open(options.times, "w", encoding="ascii") as lines:
            lines.writelines(f"{seconds:.3f} {int(converged)}\n" for seconds, converged in times)


if __name__ == "__main__":
    main()
