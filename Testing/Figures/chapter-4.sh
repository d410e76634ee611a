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
# flexure CASE NAME POINT AZIMUTH: draws the wall and the loop near a point (LPS, mm).
flexure() {
  run SurfaceColors "$1/landmarks/folds-surface.vtp" "$1-$2.png" "near=$3,90" "curves=$1/landmarks/flexures.vtp" width=2 "azimuth=$4" \
    elevation=20
}
flexure walter-reed hepatic -272,-130,363 -70
flexure walter-reed splenic -79,-135,408 150
flexure patient-20 hepatic 100,149,374 -80
flexure patient-20 splenic 283,207,436 170
panels 2 360 "walter-reed-hepatic.png=(a) hepatic, Walter Reed" "walter-reed-splenic.png=(b) splenic, Walter Reed" \
  "patient-20-hepatic.png=(a) hepatic, patient 00020" "patient-20-splenic.png=(b) splenic, patient 00020"
differs '**Agrees:** the red loop is the section of the wall with the plane across the centerline.'

# modulus POSITION SEGMENT: prints the conformal modulus of a segment.
modulus() {
  ! is_making || /usr/bin/python3 -c 'import json, sys
pieces = {piece["name"]: piece["modulus"] for piece in json.load(open(sys.argv[1]))["pieces"]}
print("%.3f" % pieces[sys.argv[2]])' "${work:?}/$1-split/landmarks.json" "$2"
}

figure 4.6 'conformal modulus of segments in two positions'
same_taeniae
titled=()
for segment in ascending transverse descending; do
  for pair in patient-20=supine second=prone; do
    position=${pair%=*}
    run ConformalMap "$position-split/segment-$segment.vtp" "$position-$segment.vtp" --domain rectangle \
      --picture "$position-$segment.png"
    titled+=("$position-$segment.png=$segment, ${pair#*=}: $(modulus "$position" $segment)")
  done
done
panels 2 430 "${titled[@]}"
differs 'Height over width of the rectangle; both positions are cut along the same taenia, the lower and upper side.' \
  '**Agrees:** the moduli of corresponding segments differ, so no conformal map takes one to the other.'

figure 4.7 'mean curvature'
same_taeniae
for position in patient-20 second; do
  run SurfaceColors $position-split/folds-surface.vtp $position-curvature.png array=meanCurvature,-0.2,0.2
done
panels 2 470 "patient-20-split/report/landmarks-anterior.png@120,40,640,464=(a) supine" \
  "second-split/report/landmarks-anterior.png@120,40,640,464=(d) prone" \
  "patient-20-curvature.png=(b) supine" "second-curvature.png=(e) prone" \
  "patient-20/flattening/report/flat-curvature.png@0,1060,840,300=(c) supine, transverse to cecum" \
  "second/flattening/report/flat-curvature.png@0,1060,840,300=(f) prone, transverse to cecum"
differs 'From -0.2/mm (blue) to 0.2/mm (red, folds). **Agrees:** the folds of both positions form the same pattern.'

# as_published: registers the two positions as in the dissertation.
as_published() {
  run ColonRegistration patient-20 second both-published --evaluate points.csv --map published \
    --report both-published/report
}

figure 4.8 'features and their matches'
both_positions
as_published
panels 2 360 "patient-20/folds/folds.png@620,1330,663,436=(a), (b) supine: folds by graph cut, green: ends" \
  "second/folds/folds.png@620,1330,663,436=prone" \
  "both/report/aligned.png@700,580,679,478=(c), (d) ours: matches that constrain the map" \
  "both-published/report/aligned.png@700,580,679,478=as published"
differs 'Ascending colon. As published: ends of folds near the main taenia (dots), matched by the printed energy. Ours: whole' \
  'folds. **Agrees:** most features have a partner, and their number differs. **Differs:** ours finds more and better' \
  'pairs (Table 4.1). Red: contradicted or wrong, black: unmatched.'

figure table-4.1 'feature correspondences'
both_positions
as_published
needs ctc/colon-lumen-mask.nii.gz ctc/colon-lumen-mask-other-position.nii.gz
run VirtualColonoscopy colon-lumen-mask.nii.gz mask --inputIsLumen
run VirtualColonoscopy colon-lumen-mask-other-position.nii.gz other-mask --inputIsLumen
run ColonRegistration mask other-mask both-masks
table matches 'patient 00020, second position=both' 'the same, as published=both-published' 'a real pair=both-masks'
differs 'Published counts are border features of one patient; who judged them is not stated. Ours are folds, or *as published*' \
  'ends of folds near the main taenia, right or wrong by the known displacement; a real pair has no truth, only' \
  'contradictions. **Agrees:** as published, most border features are matched.'
