#ifndef FuzzResultSeeds_h
#define FuzzResultSeeds_h

#include "FuzzSeeds.h"

#include "shapetonDicomSource.h"

/** The ending of the mutants of these seeds, by which they are told from slices. */
constexpr const char * ResultExtension = ".result.dcm";

/** A series that results belong to; made in `folder`. */
shapeton::DicomSource
MakeResultSource(const std::string & folder);

/** Segmentations and reports beside a source; made in `folder`. */
std::vector<FuzzSeed>
MakeResultSeeds(const std::string & folder, const shapeton::DicomSource & source);

/** Reads a file as a segmentation and as a report; whether it was one of them. */
bool
ReadAllOfResult(const std::string & path, const shapeton::DicomSource & source);
#endif
