#ifndef shapetonDicomTransferSyntax_h
#define shapetonDicomTransferSyntax_h

#include "dcmtk/config/osconfig.h"
#include "dcmtk/dcmdata/dcxfer.h"

#include <map>
#include <string>

namespace shapeton
{
/** Deflated Image Frame Compression (Supplement 244), missing in DCMTK 3.6.7. */
constexpr const char * DeflatedFramesUID = "1.2.840.10008.1.2.8.1";

/** True for encodings whose pixels can be read: native ones by DCMTK, compressed ones by GDCM. */
inline bool
IsSupported(E_TransferSyntax syntax)
{
  switch (syntax)
  {
    case EXS_LittleEndianImplicit:
    case EXS_LittleEndianExplicit:
    case EXS_BigEndianImplicit:
    case EXS_BigEndianExplicit:
    case EXS_DeflatedLittleEndianExplicit:
    case EXS_JPEGProcess1:
    case EXS_JPEGProcess2_4:
    case EXS_JPEGProcess14:
    case EXS_JPEGProcess14SV1:
    case EXS_RLELossless:
    case EXS_JPEGLSLossless:
    case EXS_JPEGLSLossy:
    case EXS_JPEG2000LosslessOnly:
    case EXS_JPEG2000:
      return true;
    default:
      return false;
  }
}

/** The syntax of JPEG 2000 as which DCMTK parses High-Throughput JPEG 2000, and OpenJPEG 2.5 decodes it; EXS_Unknown
 * for other syntaxes. */
inline E_TransferSyntax
SyntaxOfHighThroughput(const std::string & uid)
{
  const std::string family = "1.2.840.10008.1.2.4.20";
  return uid == family + "1" || uid == family + "2" ? EXS_JPEG2000LosslessOnly
         : uid == family + "3"                      ? EXS_JPEG2000
                                                    : EXS_Unknown;
}

/** True for encodings that are always lossy; for the others see Lossy Image Compression. */
inline bool
IsLossy(E_TransferSyntax syntax)
{
  return syntax == EXS_JPEGProcess1 || syntax == EXS_JPEGProcess2_4 || syntax == EXS_JPEGLSLossy;
}

/** The name of a transfer syntax newer than DCMTK 3.6.7; otherwise its UID. */
inline std::string
NameOfNewTransferSyntax(const std::string & uid)
{
  static const std::map<std::string, std::string> names{
    { "1.2.840.10008.1.2.4.110", "JPEG XL Lossless" },
    { "1.2.840.10008.1.2.4.111", "JPEG XL JPEG Recompression" },
    { "1.2.840.10008.1.2.4.112", "JPEG XL" },
    { "1.2.840.10008.1.2.4.201", "High-Throughput JPEG 2000 (Lossless Only)" },
    { "1.2.840.10008.1.2.4.202", "High-Throughput JPEG 2000 with RPCL Options (Lossless Only)" },
    { "1.2.840.10008.1.2.4.203", "High-Throughput JPEG 2000" }
  };
  const auto name = names.find(uid);
  return name != names.end() ? name->second + " (" + uid + ")" : uid;
}
} // namespace shapeton

#endif
