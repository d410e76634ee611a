# The colons of chapters 4 and 5; read by make-figures.
# shellcheck shell=bash disable=SC2016

# walter_reed: a CT in prone position, 1.25 x 1.25 x 2 mm.
walter_reed() {
  needs ctc/walter-reed/prone.nii.gz
  run VirtualColonoscopy prone.nii.gz walter-reed --position prone
}

# patient_20: a lumen drawn by experts, 0.8 x 0.8 x 0.7 mm.
patient_20() {
  needs ctc/gut-cell-atlas/00020-lumen.nrrd
  run VirtualColonoscopy 00020-lumen.nrrd patient-20 --inputIsLumen
}

# both_positions: patient 00020 and a simulated second position with known correspondence, registered.
both_positions() {
  patient_20
  run second-position.py 00020-lumen.nrrd second.nrrd points.csv
  run VirtualColonoscopy second.nrrd second --inputIsLumen
  run ColonRegistration patient-20 second both --evaluate points.csv --report both/report
}

# same_taeniae: the landmarks of both positions, split along one taenia, with the numbers of the first position.
same_taeniae() {
  both_positions
  run ColonLandmarks patient-20/flattening/flat.vtp patient-20/segmentation/centerline.vtp patient-20-split --split \
    --report patient-20-split/report
  run ColonLandmarks second/flattening/flat.vtp second/segmentation/centerline.vtp second-split --split \
    --registration both/registration.json --report second-split/report
}

# raw_wall: the wall of patient 00020 with its handles, flattened without repair.
raw_wall() {
  patient_20
  run ColonFlattening patient-20/segmentation/wall.vtp raw.vtp --centerline patient-20/segmentation/centerline.vtp \
    --statistics raw.json --handles raw-handles.vtp --report raw
}
