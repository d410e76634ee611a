# Chapter 4: landmarks of the colon; read by make-figures.
# shellcheck shell=bash disable=SC2016

chapter 4 'landmarks of the colon'
write 'Walter Reed: a patient in prone position. Patient 00020: its *second position* (named prone) is simulated by a known smooth' \
  'displacement of up to 15 mm, which creates no new folds and moves no gas, so it is easier than a real one. Table 4.1 also has' \
  'a real pair.' ''

figure 4.1 'haustral folds on the surface'
walter_reed
patient_20
panels 2 430 "walter-reed/landmarks/report/folds-surface.png@140,40,620,815=(a) Walter Reed, prone" \
  "patient-20/landmarks/report/folds-surface.png@140,40,620,815=(b) patient 00020"
differs 'Published: mean curvature in [-4.5, -0.5]. Ours: smoothed by heat diffusion, in 1/mm, with a threshold from each' \
  'surface. **Agrees:** folds are found on the whole surface, 254 and 267. **Differs:** from outside, a fold is a furrow.' \
  'The long blue band at the cecum of Walter Reed is not a fold.'

figure 4.2 'taeniae coli'
walter_reed
panels 2 430 "walter-reed/landmarks/report/landmarks-anterior.png@140,40,640,815=front" \
  "walter-reed/landmarks/report/landmarks-posterior.png@140,40,640,815=back"
differs '**Agrees:** the lines run between the rows of haustra through the whole colon, without markers; the dissertation' \
  'needed markers in 2 of 9 data sets. **Differs:** our two methods disagree by more than 10 mm along 17 % of this colon,' \
  'and the tool warns.'

figure 4.3 'a taenia in transverse and ascending colon'
walter_reed
panels 2 400 "walter-reed/landmarks/report/landmarks-anterior.png@190,45,460,350=(a) transverse" \
  "walter-reed/landmarks/report/landmarks-posterior.png@500,130,330,251=(b) ascending, from behind"
differs 'Taenia 1 is yellow, as published. **Agrees:** it runs straight between the rows of haustra in both segments.'

figure 4.4 'four flexures and the segments between them'
walter_reed
patient_20
run ColonLandmarks walter-reed/flattening/flat.vtp walter-reed/segmentation/centerline.vtp walter-reed-published \
  --flexureRule published --report walter-reed-published/report
run ColonLandmarks patient-20/flattening/flat.vtp patient-20/segmentation/centerline.vtp patient-20-published \
  --flexureRule published --report patient-20-published/report
panels 4 230 "walter-reed/landmarks/report/landmarks-anterior.png@140,40,640,815=Walter Reed, ours" \
  "walter-reed-published/report/landmarks-anterior.png@140,40,640,815=Walter Reed, published rule" \
  "patient-20/landmarks/report/landmarks-anterior.png@140,40,640,815=patient 00020, ours" \
  "patient-20-published/report/landmarks-anterior.png@140,40,640,815=patient 00020, published rule"
differs 'From the rectum: red, orange, green, teal, blue, purple; gray: unknown. **Agrees:** one color per segment. In patient' \
  '00020, our splenic flexure, hepatic flexure and ileocecal valve are 35, 35 and 8 mm from those of experts, our end of' \
  'the descending colon 58 mm. **Differs:** in both colons, the published rule takes neighboring bends near the spleen' \
  'for splenic and hepatic flexure.'

figure 4.5 'hepatic and splenic flexure'
walter_reed
patient_20
panels 2 360 "walter-reed/landmarks/report/landmarks-posterior.png@520,80,300,300=(a) hepatic, Walter Reed" \
  "walter-reed/landmarks/report/landmarks-posterior.png@170,32,300,300=(b) splenic, Walter Reed" \
  "patient-20/landmarks/report/landmarks-posterior.png@520,80,300,300=(a) hepatic, patient 00020" \
  "patient-20/landmarks/report/landmarks-posterior.png@200,32,300,300=(b) splenic, patient 00020"
differs 'Seen from behind. The black loop is the section of the wall with the plane across the centerline, as published (there' \
  'red).'

# split POSITION: cuts the wall into segments and maps each; both are results of the figure.
split() {
  run ColonLandmarks "$1/flattening/flat.vtp" "$1/segmentation/centerline.vtp" "$1-split" --split
  for segment in ascending transverse descending; do
    run ConformalMap "$1-split/segment-$segment.vtp" "$1-$segment.vtp" --domain rectangle --picture "$1-$segment.png"
  done
}

figure 4.6 'conformal modulus of segments in two positions'
both_positions
split patient-20
split second
panels 2 430 "patient-20-ascending.png=ascending, supine: 0.643" "second-ascending.png=prone: 0.680" \
  "patient-20-transverse.png=transverse, supine: 0.217" "second-transverse.png=prone: 0.220" \
  "patient-20-descending.png=descending, supine: 0.288" "second-descending.png=prone: 0.278"
differs 'Height over width of the rectangle. **Agrees:** the moduli of corresponding segments differ, here by 6, 2 and 3 %, so' \
  'no conformal map takes one to the other.'

figure 4.7 'mean curvature'
both_positions
panels 2 470 "patient-20/landmarks/report/landmarks-anterior.png@120,40,640,464=(a) supine" \
  "second/landmarks/report/landmarks-anterior.png@120,40,640,464=(d) prone" \
  "patient-20/flattening/report/flat-curvature.png@0,1030,945,346=(c) supine, transverse to cecum" \
  "second/flattening/report/flat-curvature.png@0,1030,945,346=(f) prone, transverse to cecum"
differs 'From -0.2/mm (blue) to 0.2/mm (red, folds). **Agrees:** the folds of both positions form the same pattern. (b) and' \
  '(e), the colors in space, are not drawn.'

# as_published: registers the two positions as in the dissertation.
as_published() {
  run ColonRegistration patient-20 second both-published --evaluate points.csv --map published --matching dualDecomposition \
    --report both-published/report
}

figure 4.8 'features and their matches'
both_positions
as_published
panels 2 360 "patient-20/folds/folds.png@620,1330,663,436=(a), (b) supine: folds by graph cut, green: ends" \
  "second/folds/folds.png@620,1330,663,436=prone" \
  "both/report/aligned.png@700,580,679,478=(c), (d) ours: matches that constrain the map" \
  "both-published/report/aligned.png@700,580,679,478=as published"
differs 'Ascending colon. Published: ends of large folds near the taenia, matched by dual decomposition. Ours: whole folds,' \
  'matched exactly. **Agrees:** most folds have a partner, and the number of folds differs. **Differs:** ours finds more' \
  'and better pairs (Table 4.1). Red: contradicted or wrong, black: unmatched.'

figure table-4.1 'feature correspondences'
both_positions
as_published
needs ctc/colon-lumen-mask.nii.gz ctc/colon-lumen-mask-other-position.nii.gz
run VirtualColonoscopy colon-lumen-mask.nii.gz mask --inputIsLumen
run VirtualColonoscopy colon-lumen-mask-other-position.nii.gz other-mask --inputIsLumen
run ColonRegistration mask other-mask both-masks
table matches 'patient 00020, second position=both' 'the same, as published=both-published' 'a real pair=both-masks'
differs 'Published counts are border features of one patient; who judged them is not stated. Ours are folds, right or wrong by' \
  'the known displacement; a real pair has no truth, only contradictions. *As published*: dual decomposition and the map' \
  'of 4.3 and 5.4.2.'
