#ifndef FuzzSeeds_h
#define FuzzSeeds_h

#include <string>
#include <vector>

/** A valid file to mutate. */
struct FuzzSeed
{
  /** File extension of mutants, which selects the format in the reader. */
  std::string extension;
  std::string bytes;
  /** Compress the bytes with gzip after the mutation. A mutated gzip file would only fail its checksum, so the code
   * after decompression would not be tested. */
  bool isGzipped{ false };
};

/** DICOM slices and multi-frame files in several encodings, NRRD, NIfTI and MetaImage files, and surfaces in all
 * supported formats; created in `folder`. */
std::vector<FuzzSeed>
MakeFuzzSeeds(const std::string & folder);

/** Compresses the bytes to a gzip file. */
std::string
Gzip(const std::string & bytes);
#endif
