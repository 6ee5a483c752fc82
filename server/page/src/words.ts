// Every word of the page, in the languages it speaks; chosen by the browser's language.

const en = {
  title: 'Leda', language: 'Français', menu: 'Steps',
  step_dem: 'Ground', step_draw: 'Sections', step_soil: 'Soil', step_run: 'Run', step_look: 'Results',
  step_compare: 'Compare', step_take: 'Download',
  next: 'Next: {step}', loading: 'Loading…', none: 'none', close: 'Close', remove: 'Remove', add: 'Add',

  no_answer: 'The server does not answer. What you typed is kept; the page goes on by itself when it is back.',
  token_title: 'This server asks for a token',
  token_why: 'Whoever runs the server makes one with “leda token NAME --role submit”. It is kept until this tab is closed.',
  token: 'Token', token_refused: 'The server refused this token. Check that all of it was copied.', enter: 'Enter',
  forget_token: 'Forget token',

  dem_intro: 'Start with a digital elevation model: a GeoTIFF in metres, in a projected coordinate system.',
  dem_drop: 'Drop a GeoTIFF here, or', dem_choose: 'choose a file', dem_file: 'GeoTIFF file', dem_name: 'Name',
  dem_more: 'If the file does not say', dem_epsg: 'EPSG code', dem_unit: 'Unit of elevation', dem_nodata: 'Value without data',
  dem_send: 'Upload', dem_sending: 'Sending: {percent} %', dem_checking: 'Sent. The server checks the file…',
  dem_known: 'Known ground', dem_none: 'No ground yet: upload one above.', dem_use: 'Use',
  dem_in_use: 'on the map', dem_as_in_file: 'as in the file', dem_no_file: 'Choose a file first.',
  dem_lost: 'The connection was lost on the way. Nothing was registered: press Upload again.',
  size: 'Size', cells: 'cells', cell: 'Cell', elevation: 'Elevation', no_data: 'Without data', crs: 'CRS',
  share_no_data: '{percent} % of the cells', outside: 'outside the ground', no_data_here: 'no data here',
  warnings: 'Warnings', no_warnings: 'No warnings.',

  draw_intro: 'Sections are cut where you say. Trace a river or a crest and they are laid across it, or draw single ones.',
  draw_along: 'Trace a line', draw_section: 'Draw a section', draw_stop: 'Stop drawing (Esc)',
  draw_hint_along: 'Click along the river or crest; double-click to end.',
  draw_hint_section: 'Click the start on the plateau, then the end beyond the river.',
  draw_hint_region: 'Click the corners of the area; double-click to end.',
  draw_edit: 'Points of a line can be dragged on the map.',
  line_along: 'Line', section: 'Section', name: 'Name', spacing_m: 'Spacing, m', upslope_m: 'Uphill, m',
  downslope_m: 'Downhill, m', points: 'Points (x y, one a line)', draw_none: 'Nothing drawn yet.',
  laid: '{count} sections', laid_left_out: '{count} of them left out', profile_of: 'Profile of {name}',
  drag_hint: 'Drag crest or toe to correct it.',
  drag_not: 'Crest and toe of a section laid along a line are found by the server; draw a section of its own to set them.',
  reset_bank: 'As the server finds them', need_dem: 'Choose the ground first.', need_name: 'Give the job a name.',
  need_sections: 'Draw a section or trace a line first.', pick_section: 'Look at',

  soil_intro: 'What the ground is made of, top down. Start from a site of the thesis and change what you know better.',
  preset: 'Start from', preset_apply: 'Use this soil', preset_asked: 'This replaces the soil typed below.',
  soil_model: 'Soil', region_draw: 'Draw its area', region_count: '{count} areas',
  everywhere: 'everywhere else', region_clear: 'Remove areas', model_add: 'Another soil for a part of the map',
  curve: 'Softening of {material}', curve_measured: 'as measured', curve_cell: 'in a cell of {cell} m',
  curve_x: 'plastic shear strain', curve_y: 'strength, kPa', curve_missing: 'The curve shows when all its numbers are there.',
  settings: 'Settings', import: 'Import request', export: 'Export request', import_bad: 'This file is no request: {why}',
  add_field: 'Add a value…', add_layer: 'Add a layer', add_material: 'Add a material', up: 'Up',
  kind: 'kind', constant: 'constant',
  layers_on_profile: 'Layers on the profile of {name}',

  run_intro: 'A dry run says what the job would cost before anything is computed.',
  job_name: 'Name of the job', dry_run: 'Dry run', submit: 'Submit', submitting: 'Asking the server…',
  faults: 'The server refused {count} values. They are marked in their steps.', fault_go: 'Show',
  fault_one: 'The server refused one value. It is marked in its step.',
  est_runs: 'Runs', est_left_out: 'Left out', est_stable: 'Stable by screening', est_core_hours: 'Core-hours',
  est_at_least: 'at least', est_at_most: 'at most', est_disk: 'Disk', est_particles: 'Particles', est_basis: 'Based on',
  dry_ok: 'The request is sound.', section_notes: 'Sections with a remark',

  jobs: 'Jobs', jobs_none: 'No job yet.', job: 'Job', job_cancel: 'Cancel', job_retry: 'Retry what failed',
  job_show: 'Show', status: 'Status', progress: 'Progress',
  accepted: 'waiting', running: 'running', successful: 'finished', failed: 'failed', dismissed: 'cancelled',
  colour_by: 'Colour by', by_status: 'status', by_retrogression: 'retrogression', by_runout: 'runout', by_cost: 'run time',
  retrogression: 'Retrogression', runout: 'Runout', run_time: 'Run time', lower_bound: 'lower bound (dashed)',
  legend: 'Legend', layer_release: 'Release zones', layer_runout: 'Runout zones', layer_release_probability: 'Probability of release',
  layer_runout_probability: 'Probability of runout', goes_beyond: '{percent} of runs go beyond it', as_given: 'as given',
  layer_sections: 'Sections', layer_hillshade: 'Hillshade', layers: 'Layers',
  filter: 'Find a section', more_rows: 'Show {count} more', no_value: 'no value',
  state_waiting: 'waiting', state_running: 'running', state_at_rest: 'slid, at rest', state_stable: 'stable',
  state_time_limit: 'stopped by its time limit', state_left_domain: 'left the model', state_unstable: 'unstable',
  state_failed: 'failed', state_left_out: 'left out', state_dismissed: 'cancelled',
  study_picture: 'Error against run time', study_settings: 'Settings of the study',
  study_particles: 'Particles per cell', study_error: 'Error', study_reference: 'reference', study_within: 'within the wanted error',
  study_fastest: 'fastest within the wanted error', study_svg: 'Picture as SVG', study_csv: 'Runs as CSV', not_on_map: 'This job has no map.',

  profile: 'Profile', before: 'before', after: 'after', crest: 'crest', toe: 'toe', backscarp: 'backscarp', front: 'front',
  numbers: 'Numbers', screening: 'Screening', log: 'Log', animation: 'Animation',
  from_crest: 'Runout from the crest', slides: 'Slides', simulated: 'Simulated time', particles: 'Particles',
  speed_of_run: 'Per particle and step', attempts: 'Tries', version: 'Version', case_hash: 'Hash of the case',
  dem_hash: 'Hash of the DEM', mass: 'Mass audit', momentum: 'Momentum audit', energy: 'Energy audit', trigger: 'Trigger',
  at_least: 'at least', difference: 'Difference', no_result: 'There is no result yet.', reason: 'Reason',
  download_json: 'Section as JSON', download_fields: 'Particles as HDF5', download_svg: 'Profile as SVG', download_log: 'Log as text',
  elevation_axis: 'elevation, m', distance_axis: 'distance, m', stretched: 'heights × {factor}',

  ensemble_intro: 'Numbers that are not known well, as distributions: many members are run with draws of them, and tell how probable a distance is.',
  ensemble: 'How sure', members: 'Members', sliding: 'Probability of sliding', half_width: 'Curves known to', wanted: 'wanted',
  condition: 'Conditional on a slide starting at the section: no yearly probability and no class of a regulation.',
  ended_by: 'Ended by', ended_half_width: 'curves known well enough', ended_max_members: 'the most members allowed',
  ended_more_members: 'not yet: more members are run',
  beyond_retrogression: 'Probability that retrogression goes beyond a distance',
  beyond_runout: 'Probability that runout goes beyond a distance', probability_axis: 'probability',
  band_is: 'Band: interval of {percent} %', cut_short: 'from here on members were cut short and may reach further',
  exceeded_by: 'Exceeded by', exceeded: 'Distances exceeded with a probability', distance: 'Distance', by_ranks: 'Interval (ranks)', and_more: '{distance} and more',
  decides: 'What decides', share_of_variance: 'Share of the variance (first order) ± standard error', chance: 'chance',
  chance_is: '± {metres} m: {members} members with {runs} seeds each', finer_cell: 'finer cells',
  finer_cell_is: '{metres} m over {pairs} pairs', few_members: 'Not known with so few members.',
  download_curves: 'Curves as SVG', not_yet_sure: 'Nothing to say yet: {why}',

  anim_field: 'Show', plastic_strain: 'plastic strain', speed: 'speed, m/s', material: 'material', play: 'Play',
  pause: 'Pause', frame: 'Frame', time: '{time} s', anim_two: 'This run kept its first and last frame only. Ask for more with “frame interval” in the settings of the next one.',
  anim_none: 'This run left no frames.',

  compare_intro: 'Two sections side by side, at one scale: of one job or of two.',
  first: 'First', second: 'Second', compare_need: 'A job with sections is needed first.',

  take_intro: 'What this job made, for other programs.', take_need: 'Show a finished job first.',
  take_gpkg: 'GeoPackage, styled for QGIS', take_geojson: 'GeoJSON', take_shp: 'Shapefile', take_fgb: 'FlatGeobuf',
  take_report: 'Report as one HTML file', take_report_making: 'Making the report: {done} of {all} sections',
  take_release_probability: 'Probability of release, GeoTIFF', take_runout_probability: 'Probability of runout, GeoTIFF',
  take_style: 'Style for QGIS', take_members: 'Members as CSV',
  take_request: 'The request', take_hillshade: 'Hillshade as PNG',
  report_title: 'Leda: report of {name}', report_made: 'Made', report_map: 'Map', report_sections: 'Sections',
  report_zones: 'Zones', report_profiles: 'Profiles', report_settings: 'Settings', report_hashes: 'Hashes',
  report_scope: 'Conditional on a slide starting at a section. No yearly probability, no regulatory class.',
  report_probability: 'Zones of probability',
  report_only: 'Profiles of the first {count} sections.', zone: 'Zone', largest: 'Largest distance', mean: 'Mean distance',
  measured: 'measured', 'lower-bound': 'lower bound', unknown_for_bound: 'unknown: a lower bound',

  field_layers: 'Layers', field_materials: 'Materials', field_material: 'Material', field_thickness_m: 'Thickness',
  field_bottom_m: 'Bottom, elevation', field_bottom_below_toe_m: 'Bottom below the toe', field_water_table: 'Water table',
  field_depth_m: 'Depth below ground', field_base_m: 'Base, elevation', field_base_below_toe_m: 'Base below the toe',
  field_unit_weight_kN_m3: 'Unit weight', field_shear_modulus_kPa: 'Shear modulus', field_youngs_modulus_kPa: 'Young’s modulus',
  field_poisson_ratio: 'Poisson’s ratio', field_peak_strength_kPa: 'Peak strength', field_k0: 'K₀ (effective stresses)',
  field_drainage: 'Drainage', field_drained: 'Drained strength', field_cohesion_kPa: 'Cohesion', field_friction_angle_deg: 'Friction angle',
  field_softening: 'Softening', field_law: 'Law', field_alpha: 'α', field_beta: 'β', field_residual_strain: 'Residual strain γR',
  field_remolded_strength_kPa: 'Remolded strength', field_residual_strength_kPa: 'Residual strength',
  field_remolded_strain: 'Remolded strain γr', field_reference_size_m: 'Size of the specimen', field_regularization: 'Scaling to the cell',
  field_band_m: 'Thickness of the band', field_strain_95: 'Strain γ95', field_shape_factor: 'Shape factor',
  field_large_strain: 'Large strain', field_large_strain_strength_kPa: 'Strength at large strain', field_rate: 'Rate',
  field_flow: 'Flow', field_tensile_strength_kPa: 'Tensile strength', field_per_decade: 'Share per decade',
  field_exponent: 'Exponent', field_viscosity: 'Viscosity', field_reference_rate_per_s: 'Reference rate',
  field_remolded: 'Of the remolded strength', field_viscosity_Pa_s: 'Viscosity', field_consistency_Pa_sn: 'Consistency, Pa sⁿ',
  field_field: 'Variation within the ground', field_cov: 'Coefficient of variation',
  field_horizontal_m: 'Scale of fluctuation along the section', field_vertical_m: 'Scale of fluctuation upwards',
  field_at_depth_m: 'Strength over depth (m, kPa)', field_at_elevation_m: 'Strength over elevation (m, kPa)',
  field_trigger: 'Trigger', field_kind: 'Kind', field_then_toe_cut_m: 'Cut at the toe if at rest', field_resolution: 'Resolution',
  field_cell_m: 'Cell', field_particles_per_cell: 'Particles per cell', field_seed: 'Seed', field_stop: 'Stop',
  field_max_time_s: 'Longest simulated time', field_output: 'Output', field_frame_interval_s: 'Frame interval (0: first and last)',
  field_paraview: 'Files for ParaView', field_screening: 'Screening', field_skip_stable: 'Do not simulate stable sections',
  field_damping: 'Damping', field_initial: 'While stress forms', field_dynamic: 'While it moves', field_time_step_factor: 'Time step factor',
  field_name: 'Name', field_ensemble: 'Ensemble', field_inputs: 'Uncertain numbers', field_path: 'Path in the request',
  field_apply: 'Applied as', field_scope: 'Same draw within', field_distribution: 'Distribution', field_type: 'Type',
  field_normal: 'normal', field_lognormal: 'lognormal', field_uniform: 'uniform', field_discrete: 'discrete',
  field_sample: 'rows of a table', field_mean: 'Mean', field_sd: 'Standard deviation', field_min: 'Least', field_max: 'Most',
  field_median: 'Median', field_sd_ln: 'Standard deviation of the logarithm', field_mode: 'Mode', field_values: 'Values',
  field_weights: 'Weights', field_set: 'Table', field_rank_correlations: 'Rank correlations', field_between: 'Between',
  field_rho: 'ρ (Spearman)', field_sampling: 'Sampling', field_method: 'Method', field_replicates: 'Replicates',
  field_min_members: 'Fewest members', field_max_members: 'Most members', field_half_width: 'Curves known to',
  field_confidence: 'Confidence', field_check: 'Check of chance and cell', field_members: 'Members', field_seeds: 'Seeds',
  field_exceedance: 'Probabilities of exceedance', field_raster: 'Rasters',
};

export type Word = keyof typeof en;

const fr: Record<Word, string> = {
  title: 'Leda', language: 'English', menu: 'Étapes',
  step_dem: 'Terrain', step_draw: 'Profils', step_soil: 'Sol', step_run: 'Calcul', step_look: 'Résultats',
  step_compare: 'Comparer', step_take: 'Télécharger',
  next: 'Suite : {step}', loading: 'Chargement…', none: 'aucun', close: 'Fermer', remove: 'Retirer', add: 'Ajouter',

  no_answer: 'Le serveur ne répond pas. Ce que vous avez saisi est gardé ; la page reprend d’elle-même à son retour.',
  token_title: 'Ce serveur demande un jeton',
  token_why: 'La personne qui gère le serveur en crée un par « leda token NOM --role submit ». Il est gardé jusqu’à la fermeture de cet onglet.',
  token: 'Jeton', token_refused: 'Le serveur a refusé ce jeton. Vérifiez qu’il a été copié en entier.', enter: 'Entrer',
  forget_token: 'Oublier le jeton',

  dem_intro: 'Commencez par un modèle numérique de terrain : un GeoTIFF en mètres, dans un système de coordonnées projeté.',
  dem_drop: 'Déposez un GeoTIFF ici, ou', dem_choose: 'choisissez un fichier', dem_file: 'Fichier GeoTIFF', dem_name: 'Nom',
  dem_more: 'Si le fichier ne le dit pas', dem_epsg: 'Code EPSG', dem_unit: 'Unité d’altitude', dem_nodata: 'Valeur sans donnée',
  dem_send: 'Envoyer', dem_sending: 'Envoi : {percent} %', dem_checking: 'Envoyé. Le serveur vérifie le fichier…',
  dem_known: 'Terrains connus', dem_none: 'Aucun terrain : envoyez-en un ci-dessus.', dem_use: 'Utiliser',
  dem_in_use: 'sur la carte', dem_as_in_file: 'selon le fichier', dem_no_file: 'Choisissez d’abord un fichier.',
  dem_lost: 'La connexion s’est perdue en route. Rien n’a été enregistré : envoyez de nouveau.',
  size: 'Taille', cells: 'mailles', cell: 'Maille', elevation: 'Altitude', no_data: 'Sans donnée', crs: 'SCR',
  share_no_data: '{percent} % des mailles', outside: 'hors du terrain', no_data_here: 'sans donnée ici',
  warnings: 'Avertissements', no_warnings: 'Aucun avertissement.',

  draw_intro: 'Les profils sont coupés où vous le dites. Tracez une rivière ou une crête et ils se placent en travers, ou dessinez-les un à un.',
  draw_along: 'Tracer une ligne', draw_section: 'Dessiner un profil', draw_stop: 'Cesser de dessiner (Échap)',
  draw_hint_along: 'Cliquez le long de la rivière ou de la crête ; double-cliquez pour finir.',
  draw_hint_section: 'Cliquez le début sur le plateau, puis la fin au-delà de la rivière.',
  draw_hint_region: 'Cliquez les sommets de l’aire ; double-cliquez pour finir.',
  draw_edit: 'Les points d’une ligne se déplacent sur la carte.',
  line_along: 'Ligne', section: 'Profil', name: 'Nom', spacing_m: 'Espacement, m', upslope_m: 'Vers l’amont, m',
  downslope_m: 'Vers l’aval, m', points: 'Points (x y, un par ligne)', draw_none: 'Rien de dessiné.',
  laid: '{count} profils', laid_left_out: 'dont {count} écartés', profile_of: 'Profil {name}',
  drag_hint: 'Déplacez la crête ou le pied pour les corriger.',
  drag_not: 'La crête et le pied d’un profil placé le long d’une ligne sont trouvés par le serveur ; dessinez un profil à part pour les fixer.',
  reset_bank: 'Comme le serveur les trouve', need_dem: 'Choisissez d’abord le terrain.', need_name: 'Donnez un nom au calcul.',
  need_sections: 'Dessinez d’abord un profil ou tracez une ligne.', pick_section: 'Regarder',

  soil_intro: 'De quoi le sol est fait, de haut en bas. Partez d’un site de la thèse et changez ce que vous savez mieux.',
  preset: 'Partir de', preset_apply: 'Prendre ce sol', preset_asked: 'Ceci remplace le sol saisi ci-dessous.',
  soil_model: 'Sol', region_draw: 'Dessiner son aire', region_count: '{count} aires',
  everywhere: 'partout ailleurs', region_clear: 'Retirer les aires', model_add: 'Un autre sol pour une partie de la carte',
  curve: 'Radoucissement de {material}', curve_measured: 'mesuré', curve_cell: 'dans une maille de {cell} m',
  curve_x: 'déformation plastique de cisaillement', curve_y: 'résistance, kPa',
  curve_missing: 'La courbe paraît quand tous ses nombres y sont.',
  settings: 'Réglages', import: 'Importer une demande', export: 'Exporter la demande', import_bad: 'Ce fichier n’est pas une demande : {why}',
  add_field: 'Ajouter une valeur…', add_layer: 'Ajouter une couche', add_material: 'Ajouter un matériau', up: 'Monter',
  kind: 'genre', constant: 'constante',
  layers_on_profile: 'Couches sur le profil {name}',

  run_intro: 'Un essai à blanc dit ce que coûterait le calcul avant de rien calculer.',
  job_name: 'Nom du calcul', dry_run: 'Essai à blanc', submit: 'Lancer', submitting: 'Le serveur est consulté…',
  faults: 'Le serveur a refusé {count} valeurs. Elles sont marquées dans leurs étapes.', fault_go: 'Montrer',
  fault_one: 'Le serveur a refusé une valeur. Elle est marquée dans son étape.',
  est_runs: 'Simulations', est_left_out: 'Écartés', est_stable: 'Stables d’après le tri', est_core_hours: 'Heures de cœur',
  est_at_least: 'au moins', est_at_most: 'au plus', est_disk: 'Disque', est_particles: 'Particules', est_basis: 'D’après',
  dry_ok: 'La demande est bonne.', section_notes: 'Profils avec une remarque',

  jobs: 'Calculs', jobs_none: 'Aucun calcul.', job: 'Calcul', job_cancel: 'Annuler', job_retry: 'Reprendre les échecs',
  job_show: 'Montrer', status: 'État', progress: 'Avancement',
  accepted: 'en attente', running: 'en cours', successful: 'terminé', failed: 'en échec', dismissed: 'annulé',
  colour_by: 'Couleur selon', by_status: 'l’état', by_retrogression: 'la rétrogression', by_runout: 'l’étalement', by_cost: 'le temps de calcul',
  retrogression: 'Rétrogression', runout: 'Étalement', run_time: 'Temps de calcul', lower_bound: 'borne inférieure (tirets)',
  legend: 'Légende', layer_release: 'Zones de départ', layer_runout: 'Zones d’étalement', layer_release_probability: 'Probabilité de départ',
  layer_runout_probability: 'Probabilité d’étalement', goes_beyond: '{percent} des simulations vont au-delà', as_given: 'sans tirage',
  layer_sections: 'Profils', layer_hillshade: 'Relief ombré', layers: 'Couches de la carte',
  filter: 'Chercher un profil', more_rows: 'Montrer {count} de plus', no_value: 'sans valeur',
  state_waiting: 'en attente', state_running: 'en cours', state_at_rest: 'a glissé, au repos', state_stable: 'stable',
  state_time_limit: 'arrêté par sa limite de temps', state_left_domain: 'sorti du modèle', state_unstable: 'instable',
  state_failed: 'en échec', state_left_out: 'écarté', state_dismissed: 'annulé',
  study_picture: 'Erreur selon le temps de calcul', study_settings: 'Réglages de l’étude',
  study_particles: 'Particules par maille', study_error: 'Erreur', study_reference: 'référence', study_within: 'dans l’erreur voulue',
  study_fastest: 'le plus rapide dans l’erreur voulue', study_svg: 'Image en SVG', study_csv: 'Simulations en CSV', not_on_map: 'Ce calcul n’a pas de carte.',

  profile: 'Profil', before: 'avant', after: 'après', crest: 'crête', toe: 'pied', backscarp: 'escarpement', front: 'front',
  numbers: 'Nombres', screening: 'Tri', log: 'Journal', animation: 'Animation',
  from_crest: 'Étalement depuis la crête', slides: 'Glissements', simulated: 'Temps simulé', particles: 'Particules',
  speed_of_run: 'Par particule et pas', attempts: 'Essais', version: 'Version', case_hash: 'Empreinte du cas',
  dem_hash: 'Empreinte du MNT', mass: 'Bilan de masse', momentum: 'Bilan de quantité de mouvement', energy: 'Bilan d’énergie', trigger: 'Déclencheur',
  at_least: 'au moins', difference: 'Différence', no_result: 'Pas encore de résultat.', reason: 'Raison',
  download_json: 'Profil en JSON', download_fields: 'Particules en HDF5', download_svg: 'Profil en SVG', download_log: 'Journal en texte',
  elevation_axis: 'altitude, m', distance_axis: 'distance, m', stretched: 'hauteurs × {factor}',

  ensemble_intro: 'Les nombres mal connus, en lois de probabilité : de nombreux membres en sont tirés et simulés, et disent la probabilité d’une distance.',
  ensemble: 'Certitude', members: 'Membres', sliding: 'Probabilité de glisser', half_width: 'Courbes connues à', wanted: 'voulu',
  condition: 'Sous condition qu’un glissement parte du profil : ni probabilité annuelle, ni classe réglementaire.',
  ended_by: 'Arrêté par', ended_half_width: 'courbes assez bien connues', ended_max_members: 'le nombre de membres permis',
  ended_more_members: 'pas encore : d’autres membres sont simulés',
  beyond_retrogression: 'Probabilité que la rétrogression dépasse une distance',
  beyond_runout: 'Probabilité que l’étalement dépasse une distance', probability_axis: 'probabilité',
  band_is: 'Bande : intervalle à {percent} %', cut_short: 'dès ici des membres ont été coupés et peuvent aller plus loin',
  exceeded_by: 'Dépassée par', exceeded: 'Distances dépassées avec une probabilité', distance: 'Distance', by_ranks: 'Intervalle (rangs)', and_more: '{distance} et plus',
  decides: 'Ce qui décide', share_of_variance: 'Part de la variance (premier ordre) ± erreur type', chance: 'hasard',
  chance_is: '± {metres} m : {members} membres à {runs} graines chacun', finer_cell: 'mailles plus fines',
  finer_cell_is: '{metres} m sur {pairs} paires', few_members: 'Inconnu avec si peu de membres.',
  download_curves: 'Courbes en SVG', not_yet_sure: 'Rien à dire encore : {why}',

  anim_field: 'Montrer', plastic_strain: 'déformation plastique', speed: 'vitesse, m/s', material: 'matériau', play: 'Jouer',
  pause: 'Pause', frame: 'Image', time: '{time} s', anim_two: 'Cette simulation n’a gardé que sa première et sa dernière image. Demandez-en plus par « intervalle des images » dans les réglages de la prochaine.',
  anim_none: 'Cette simulation n’a laissé aucune image.',

  compare_intro: 'Deux profils côte à côte, à la même échelle : d’un calcul ou de deux.',
  first: 'Premier', second: 'Second', compare_need: 'Il faut d’abord un calcul avec des profils.',

  take_intro: 'Ce que ce calcul a produit, pour d’autres logiciels.', take_need: 'Montrez d’abord un calcul terminé.',
  take_gpkg: 'GeoPackage, avec styles pour QGIS', take_geojson: 'GeoJSON', take_shp: 'Shapefile', take_fgb: 'FlatGeobuf',
  take_report: 'Rapport en un fichier HTML', take_report_making: 'Rapport en préparation : {done} profils sur {all}',
  take_release_probability: 'Probabilité de départ, GeoTIFF', take_runout_probability: 'Probabilité d’étalement, GeoTIFF',
  take_style: 'Style pour QGIS', take_members: 'Membres en CSV',
  take_request: 'La demande', take_hillshade: 'Relief ombré en PNG',
  report_title: 'Leda : rapport de {name}', report_made: 'Fait le', report_map: 'Carte', report_sections: 'Profils',
  report_zones: 'Zones', report_profiles: 'Coupes', report_settings: 'Réglages', report_hashes: 'Empreintes',
  report_scope: 'Sous condition qu’un glissement parte d’un profil. Ni probabilité annuelle, ni classe réglementaire.',
  report_probability: 'Zones de probabilité',
  report_only: 'Coupes des {count} premiers profils.', zone: 'Zone', largest: 'Plus grande distance', mean: 'Distance moyenne',
  measured: 'mesuré', 'lower-bound': 'borne inférieure', unknown_for_bound: 'inconnue : borne inférieure',

  field_layers: 'Couches', field_materials: 'Matériaux', field_material: 'Matériau', field_thickness_m: 'Épaisseur',
  field_bottom_m: 'Bas, altitude', field_bottom_below_toe_m: 'Bas sous le pied', field_water_table: 'Nappe',
  field_depth_m: 'Profondeur sous le sol', field_base_m: 'Base, altitude', field_base_below_toe_m: 'Base sous le pied',
  field_unit_weight_kN_m3: 'Poids volumique', field_shear_modulus_kPa: 'Module de cisaillement', field_youngs_modulus_kPa: 'Module d’Young',
  field_poisson_ratio: 'Coefficient de Poisson', field_peak_strength_kPa: 'Résistance de pic', field_k0: 'K₀ (contraintes effectives)',
  field_drainage: 'Drainage', field_drained: 'Résistance drainée', field_cohesion_kPa: 'Cohésion', field_friction_angle_deg: 'Angle de frottement',
  field_softening: 'Radoucissement', field_law: 'Loi', field_alpha: 'α', field_beta: 'β', field_residual_strain: 'Déformation résiduelle γR',
  field_remolded_strength_kPa: 'Résistance remaniée', field_residual_strength_kPa: 'Résistance résiduelle',
  field_remolded_strain: 'Déformation remaniée γr', field_reference_size_m: 'Taille de l’éprouvette', field_regularization: 'Mise à l’échelle de la maille',
  field_band_m: 'Épaisseur de la bande', field_strain_95: 'Déformation γ95', field_shape_factor: 'Facteur de forme',
  field_large_strain: 'Grande déformation', field_large_strain_strength_kPa: 'Résistance à grande déformation', field_rate: 'Vitesse',
  field_flow: 'Écoulement', field_tensile_strength_kPa: 'Résistance à la traction', field_per_decade: 'Part par décade',
  field_exponent: 'Exposant', field_viscosity: 'Viscosité', field_reference_rate_per_s: 'Vitesse de référence',
  field_remolded: 'De la résistance remaniée', field_viscosity_Pa_s: 'Viscosité', field_consistency_Pa_sn: 'Consistance, Pa sⁿ',
  field_field: 'Variation dans le sol', field_cov: 'Coefficient de variation',
  field_horizontal_m: 'Échelle de fluctuation le long du profil', field_vertical_m: 'Échelle de fluctuation verticale',
  field_at_depth_m: 'Résistance selon la profondeur (m, kPa)', field_at_elevation_m: 'Résistance selon l’altitude (m, kPa)',
  field_trigger: 'Déclencheur', field_kind: 'Genre', field_then_toe_cut_m: 'Entaille au pied si au repos', field_resolution: 'Résolution',
  field_cell_m: 'Maille', field_particles_per_cell: 'Particules par maille', field_seed: 'Graine', field_stop: 'Arrêt',
  field_max_time_s: 'Plus long temps simulé', field_output: 'Sortie', field_frame_interval_s: 'Intervalle des images (0 : première et dernière)',
  field_paraview: 'Fichiers pour ParaView', field_screening: 'Tri', field_skip_stable: 'Ne pas simuler les profils stables',
  field_damping: 'Amortissement', field_initial: 'Pendant la mise en contrainte', field_dynamic: 'Pendant le mouvement', field_time_step_factor: 'Facteur du pas de temps',
  field_name: 'Nom', field_ensemble: 'Ensemble', field_inputs: 'Nombres incertains', field_path: 'Chemin dans la demande',
  field_apply: 'Appliqué comme', field_scope: 'Même tirage dans', field_distribution: 'Loi', field_type: 'Type',
  field_normal: 'normale', field_lognormal: 'lognormale', field_uniform: 'uniforme', field_discrete: 'discrète',
  field_sample: 'lignes d’un tableau', field_mean: 'Moyenne', field_sd: 'Écart type', field_min: 'Minimum', field_max: 'Maximum',
  field_median: 'Médiane', field_sd_ln: 'Écart type du logarithme', field_mode: 'Mode', field_values: 'Valeurs',
  field_weights: 'Poids', field_set: 'Tableau', field_rank_correlations: 'Corrélations de rang', field_between: 'Entre',
  field_rho: 'ρ (Spearman)', field_sampling: 'Échantillonnage', field_method: 'Méthode', field_replicates: 'Réplicats',
  field_min_members: 'Membres au moins', field_max_members: 'Membres au plus', field_half_width: 'Courbes connues à',
  field_confidence: 'Confiance', field_check: 'Contrôle du hasard et de la maille', field_members: 'Membres', field_seeds: 'Graines',
  field_exceedance: 'Probabilités de dépassement', field_raster: 'Rasters',
};

export type Language = 'en' | 'fr';
export const words: Record<Language, Record<Word, string>> = {en, fr};

const kept_as = 'leda-language';

function chosen(): Language {
  const kept = localStorage.getItem(kept_as);
  if (kept === 'en' || kept === 'fr') return kept;
  return navigator.language.toLowerCase().startsWith('fr') ? 'fr' : 'en';
}

let language: Language | undefined;

export function spoken(): Language {
  return (language ??= chosen());
}

export function speak(wanted: Language): void {
  language = wanted;
  localStorage.setItem(kept_as, wanted);
}

/** A word with its {places} filled. */
export function t(word: Word, places: Record<string, string | number> = {}): string {
  return words[spoken()][word].replace(/\{(\w+)\}/g, (_, name: string) => String(places[name] ?? ''));
}

/** The word of that name; `otherwise` where there is none. */
export function word_or(name: string, otherwise: string): string {
  return (words[spoken()] as Record<string, string | undefined>)[name] ?? otherwise;
}

/** A number as the language writes it. */
export function show(value: number | null | undefined, digits = 1): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return '–';
  return value.toLocaleString(spoken(), {maximumFractionDigits: digits});
}
