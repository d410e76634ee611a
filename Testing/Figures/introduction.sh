# The head of the page; read by make-figures.
# shellcheck shell=bash disable=SC2016

write '# Figures of the dissertation, made by our tools' '' \
  'For readers of the dissertation: which figures our tools reproduce, with which parameters, and what differs.' \
  '`Utilities/run-validation figures` makes them with the commands in [Testing/Figures](../Testing/Figures), one file per chapter;' \
  '`figures 5` makes those of chapter 5, `figures 2.4 5.3` two of them. Parameters are those of the dissertation where it states' \
  'them. [Data](#data) lists the data sets; `SHAPETON_TEST_DATA_DIR` or `--data` is their folder. The commands generate all' \
  'other data.' '' \
  'Figures not shown below:' '' \
  '| figure | shows | here |' '|---|---|---|' \
  '| 2.1 | MR head, abdominal stent, foot | head: 2.9; stent not available; [two other feet](heat-diffusion.md#few-steps-local-shape) |' \
  '| 2.2, 3.1 to 3.3, 6.7 | drawings of the method | not results |' \
  '| 2.5 | conventional and cumulative diffusion | [table](validation/heat.md#figures-24-25-and-27-of-the-dissertation); no tool implements conventional diffusion |' \
  '| 2.11, 3.12 | hand of the Visible Female | not available; her [feet](heat-diffusion.md#few-steps-local-shape) |' \
  '| Tables 2.1, 3.2 | times | [benchmarks](benchmarks.md), [shapetons](shapetons.md) |' \
  '| Table 3.1 | number of shapetons | [table](validation/shapetons.md#chd-or-shapetons) |' \
  '| 3.9 | CT chest | not available |' \
  '| 3.10 | a polyp | not made, see [PolypCandidates](../Modules/Colon/PolypCandidates/README.md) |' \
  '| 6.5; 6.12 | stages; graphs of genus 2 and 3 | see 6.1 and 6.6; 6.11 |' \
  '| 6.10 | genus 1, 10,000 nodes, one minute | 10,000 nodes and 18,000 edges on a torus take 4 s; not drawn, its circles would be too small |'
