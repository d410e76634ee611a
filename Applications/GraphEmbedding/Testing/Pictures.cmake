# Pictures of small graphs against their baselines: sphere, torus with dummies, disk in both models. Created by
#   GraphEmbedding GRAPH CERTIFICATE.json --svg PICTURE.svg [options below]
set(baselines ${here}/Baseline)

function(paints name input)
  shapeton_tool_test(NAME GraphEmbeddingPaints${name}
    COMMAND GraphEmbedding ${here}/${input} ${out}/Paints${name}.json --svg ${out}/${name}.svg ${ARGN})
  set_tests_properties(GraphEmbeddingPaints${name} PROPERTIES FIXTURES_SETUP GraphEmbeddingPaints${name}Fixture)
  add_test(NAME GraphEmbeddingBaseline${name} COMMAND ${CMAKE_COMMAND} -E compare_files --ignore-eol
    ${out}/${name}.svg ${baselines}/${name}.svg)
  set_tests_properties(GraphEmbeddingBaseline${name} PROPERTIES LABELS Applications
    FIXTURES_REQUIRED GraphEmbeddingPaints${name}Fixture)
endfunction()

paints(Cube Cube.gr)
paints(K4Minus K4Minus.gr)
paints(Mixed Mixed.gml)
paints(K5 K5.gr)
paints(K8Klein K8.gr --seed 3 --disk klein)

# VTP and report in addition to the picture; the certificate does not depend on them.
shapeton_tool_test(NAME GraphEmbeddingReport COMMAND GraphEmbedding ${here}/K8.gr ${out}/K8Report.json --seed 3
  --vtp ${out}/K8.vtp --report ${out}/K8Report --disk klein)
set_tests_properties(GraphEmbeddingReport PROPERTIES FIXTURES_SETUP GraphEmbeddingReportFixture)
add_test(NAME GraphEmbeddingReportCompare COMMAND ${CMAKE_COMMAND} -E compare_files ${out}/K8Report.json ${out}/K8.json)
set_tests_properties(GraphEmbeddingReportCompare PROPERTIES LABELS Applications
  FIXTURES_REQUIRED "GraphEmbeddingReportFixture;GraphEmbeddingK8Fixture")
add_test(NAME GraphEmbeddingReportIsThere COMMAND ${CMAKE_COMMAND} -E cat ${out}/K8Report/index.html)
set_tests_properties(GraphEmbeddingReportIsThere PROPERTIES LABELS Applications FIXTURES_REQUIRED GraphEmbeddingReportFixture
  PASS_REGULAR_EXPRESSION "<option value=\"klein\" selected")
add_test(NAME GraphEmbeddingCurvesAreThere COMMAND ${CMAKE_COMMAND} -E cat ${out}/K8.vtp)
set_tests_properties(GraphEmbeddingCurvesAreThere PROPERTIES LABELS Applications FIXTURES_REQUIRED GraphEmbeddingReportFixture
  PASS_REGULAR_EXPRESSION "Name=\"kind\"")

refuses(BadDisk 2 "disk" ${here}/K4.gr ${out}/x.json --disk hemisphere)
refuses(PictureInMissingFolder 1 "nowhere" ${here}/K4.gr ${out}/x.json --svg /proc/nowhere/x.svg)
refuses(WrongCurves 2 "vtp" ${here}/K4.gr ${out}/x.json --vtp ${out}/x.obj)
refuses(ReportIsAFile 1 "K4.gr" ${here}/K4.gr ${out}/x.json --report ${here}/K4.gr)

# The page of a sphere, for tests in a browser: Testing/Browser.
shapeton_tool_test(NAME GraphEmbeddingCubeReport COMMAND GraphEmbedding ${here}/Cube.gr ${out}/CubeReport.json --report ${out}/CubeReport)
set_tests_properties(GraphEmbeddingCubeReport PROPERTIES FIXTURES_SETUP GraphEmbeddingCubeReportFixture)
