#ifndef FuzzResultSeeds_h
#define FuzzResultSeeds_h

#include "FuzzSeeds.h"

#include "shapetonDicomSource.h"

/** File extension of mutants of these seeds, to distinguish them from slices. */
constexpr const char * ResultExtension = ".result.dcm";

/** Source series of the results; created in `folder`. */
shapeton::DicomSource
MakeResultSource(const std::string & folder);

/** Segmentations and reports of a source series; created in `folder`. */
std::vector<FuzzSeed>
MakeResultSeeds(const std::string & folder, const shapeton::DicomSource & source);

/** A deflated segmentation whose pixels claim a size of 3.5 GB: DCMTK allocates this memory before it reads them. */
std::string
MakeResultOfFalseLength(const std::string & folder, const shapeton::DicomSource & source);

/** Reads a file as a segmentation and as a report; returns whether one of them succeeded. */
bool
ReadAllOfResult(const std::string & path, const shapeton::DicomSource & source);
#endif
