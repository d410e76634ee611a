# The stages of a virtual colonoscopy and their tools. This is the single list: the C++ code includes it as
# shapetonColonoscopyStageTools.h, and the target VirtualColonoscopy depends on these tools.
set(ColonoscopyRun_STAGES inspection segmentation flattening landmarks folds registration search polyps viewer dicom)
set(ColonoscopyRun_TOOL_inspection DicomSeriesInspector)
set(ColonoscopyRun_TOOL_segmentation ColonSegmentation)
set(ColonoscopyRun_TOOL_flattening ColonFlattening)
set(ColonoscopyRun_TOOL_landmarks ColonLandmarks)
set(ColonoscopyRun_TOOL_folds ColonFolds)
set(ColonoscopyRun_TOOL_registration ColonRegistration)
set(ColonoscopyRun_TOOL_search ColonPolyps)
set(ColonoscopyRun_TOOL_polyps ColonPolyps)
set(ColonoscopyRun_TOOL_viewer ColonViewer)
set(ColonoscopyRun_TOOL_dicom ColonResultsToDicom)
