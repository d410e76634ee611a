#ifndef shapetonGraphViewerScript_h
#define shapetonGraphViewerScript_h

namespace shapeton
{
/** The style sheet and the script of the view: plain JavaScript on a canvas, without a library. */
const char *
GraphViewerStyle();
const char *
GraphViewerScript();
} // namespace shapeton

#endif
