#ifndef FuzzSeeds_h
#define FuzzSeeds_h

#include <string>
#include <vector>

/** A sound file for a mutation to spoil. */
struct FuzzSeed
{
  /** Of a mutant, so that the reader takes it for the format. */
  std::string extension;
  std::string bytes;
  /** The bytes are compressed as gzip after the mutation: a damaged gzip file is refused for its checksum, and nothing
   * behind it would be tested. */
  bool isGzipped{ false };
};

/** DICOM slices and multi-frame files in several encodings, NRRD, NIfTI and MetaImage files, and surfaces in all
 * formats that are read; made in `folder`. */
std::vector<FuzzSeed>
MakeFuzzSeeds(const std::string & folder);

/** The bytes as a gzip file. */
std::string
Gzip(const std::string & bytes);
#endif
