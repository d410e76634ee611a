#ifndef itkGraphViewerScript_h
#define itkGraphViewerScript_h

namespace itk
{
/** The style sheet and the script of the view: plain JavaScript on a canvas, without a library. */
const char *
GraphViewerStyle();
const char *
GraphViewerScript();
} // namespace itk

#endif
