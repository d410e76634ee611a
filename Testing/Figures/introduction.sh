# The head of the page; read by make-figures.
# shellcheck shell=bash disable=SC2016

write '# Figures of the dissertation, made by our tools' '' \
  'For readers of the dissertation: which figures our tools reproduce, and what differs. `Utilities/run-validation figures` makes' \
  'them; `figures 5` makes those of chapter 5, and `figures 2.4 5.3` makes two figures. The commands in' \
  '[Testing/Figures](../Testing/Figures) state all parameters, which are those of the dissertation where it states them, and' \
  'generate all data that [Data](#data) does not list. `SHAPETON_TEST_DATA_DIR` or `--data` is the folder of these data sets.' '' \
  'Figures not shown below:' '' \
  '| figure | shows | here |' '|---|---|---|' \
  '| 2.2, 3.1 to 3.3, 6.7 | drawings of the method | not results |' \
  '| 2.11, 3.11 (b) | hand of the Visible Female | not in our data; her feet: 3.11 (e), 3.12 |' \
  '| Table 2.1 | times of heat diffusion | [table](benchmarks.md#table-21-of-the-dissertation-with-our-column) with real volumes except for head, stent and hand |' \
  '| 6.11 | genus 2 in space | 6.12 in the disk; 6.5 in space |'
