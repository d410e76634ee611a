#ifndef shapetonDicomTransferSyntax_h
#define shapetonDicomTransferSyntax_h

#include "dcmtk/config/osconfig.h"
#include "dcmtk/dcmdata/dcxfer.h"

namespace shapeton
{
/** True for the encodings whose pixels can be read: native ones by DCMTK, compressed ones by GDCM. */
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

/** True for encodings that always lose something; the others say so in Lossy Image Compression. */
inline bool
IsLossy(E_TransferSyntax syntax)
{
  return syntax == EXS_JPEGProcess1 || syntax == EXS_JPEGProcess2_4 || syntax == EXS_JPEGLSLossy;
}
} // namespace shapeton

#endif
