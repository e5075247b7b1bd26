### Tout ce que dit la page, en français. Traduit sans pilote francophone ; les corrections sont bienvenues
### (docs/translating.md, en anglais). {"\u00a0"} est une espace insécable : devant : ; ? ! et dans les guillemets.

## Moving servos and motor from the page.

bench_slots = Aller à
bench_elsewhere = Les servos et le moteur agissent avec { $memory }, la mémoire du prochain vol. Affichez { $memory } pour les actionner.
bench_trim = Réglage{"\u00a0"}: { $slot }
bench_at = Servos en position { $slot }
bench_atNone = On ne sait pas où sont les servos.
bench_moveMaybe = Aucune réponse. Les servos ont peut-être bougé malgré tout. Regardez le modèle.
bench_unlocked = Le moteur est déverrouillé. L’hélice peut démarrer.
bench_unlockMaybe = Aucune réponse. Le moteur est peut-être déverrouillé malgré tout. Restez loin de l’hélice.
bench_jumped = La minuterie a confirmé le saut.
bench_here = servos ici
bench_waits = Attend l’écriture.
bench_bring = Amener les servos en position { $slot }
bench_follow = Les servos suivent les positions
bench_followHint = D’abord, la page lit la minuterie et conserve une sauvegarde. Ensuite, chaque position que vous changez à la fonction où sont les servos est écrite aussitôt dans la minuterie, et son servo bouge.
bench_followingNow = Les servos suivent{"\u00a0"}: une position que vous changez à la fonction où ils sont est écrite aussitôt dans la minuterie.
bench_stopFollowing = Arrêter le suivi
bench_ended_over = Les servos ne suivent plus.
bench_ended_memory = Les servos ne suivent plus{"\u00a0"}: une autre mémoire est sélectionnée, ou l’est peut-être.
bench_ended_strayed = Pendant que les servos suivaient, une autre mémoire est devenue la mémoire sélectionnée. Elle a peut-être pris certaines des positions{"\u00a0"}: regardez-la en entier avant de voler avec elle.
bench_ended_unlike = Les servos ne suivent plus{"\u00a0"}: la minuterie n’a pas fait ce qu’elle avait confirmé.
bench_ended_failed = Les servos ne suivent plus{"\u00a0"}: la minuterie n’a pas répondu.
bench_notTaken = { $field }{"\u00a0"}: la minuterie contient { $held }, pas { $wanted }.
bench_beside =
    { $more ->
        [0] Autres changements{"\u00a0"}: { $named }.
        [one] Autres changements{"\u00a0"}: { $named }{"\u00a0"}; et { $more } autre valeur.
       *[other] Autres changements{"\u00a0"}: { $named }{"\u00a0"}; et { $more } autres valeurs.
    }
bench_triedHere =
    { $more ->
        [0] À l’essai{"\u00a0"}: { $named }.
        [one] À l’essai{"\u00a0"}: { $named }{"\u00a0"}; et { $more } autre position.
       *[other] À l’essai{"\u00a0"}: { $named }{"\u00a0"}; et { $more } autres positions.
    }
bench_triedAndWaiting =
    { $waiting ->
        [0] { $tried } à l’essai dans la minuterie
        [one] { $tried } à l’essai dans la minuterie, { $waiting } attend l’écriture
       *[other] { $tried } à l’essai dans la minuterie, { $waiting } attendent l’écriture
    }
bench_triedIn = Des positions ont été essayées dans { $memory }.
bench_decide = Conserver ce qui a été essayé, ou rétablir ce que la minuterie contenait avant{"\u00a0"}?
bench_keep = Conserver
bench_putBack = Rétablir…
bench_unlock = Maintenir pour UNLOCK
bench_unlockHold = Continuez d’appuyer
bench_unlockHint = L’hélice peut démarrer. Tenez le modèle, gardez les mains loin de l’hélice, puis appuyez sur le bouton et maintenez-le enfoncé.
bench_experimental = Expérimental
bench_jumpHint = Saute à la fonction qui suit un DT anticipé. L’effet exact n’est pas documenté{"\u00a0"}: des servos peuvent bouger.
bench_jump = Saut…
bench_jumpSure = Envoyer le saut maintenant

## The log of flights.

flights_title = Vols
flights_empty_title = Aucun vol noté.
flights_empty_advice = Lisez une minuterie ou écrivez-y, puis appuyez sur «{"\u00a0"}{ flights_flying_button }{"\u00a0"}».
flights_failed = Le navigateur ne peut pas lire la bibliothèque en ce moment. Fermez les autres onglets de cette page et réessayez.
flights_flying_button = Noter ce vol
flights_flying_purpose = Note un vol avec ce que contient la minuterie.
flights_flying_logged = Vol noté ({ $time })
flights_flying_fillIn = Compléter
flights_flying_again = Noter encore ce vol
flights_row_round = Manche { $round }
flights_row_wind = { $wind } m/s
flights_row_temperature = { $degrees } °C
flights_row_noResult = sans résultat
flights_row_changed = { $values } ont changé
flights_row_otherTimer = autre minuterie
flights_totals_flights =
    { $count ->
        [one] { $count } vol
       *[other] { $count } vols
    }
flights_totals_best = meilleur { $time }
flights_totals_average = moyenne { $time }
flights_filter_of = Vols{"\u00a0"}: { $name }
flights_filter_clear = Tout afficher
flights_form_title = Vol
flights_form_result = Résultat
flights_form_resultHint = En secondes, ou en minutes comme 2:58.
flights_form_readAs = { $time }, { $seconds } s
flights_form_propose = Noter { $facts }
flights_form_full = Manche pleine, 180 s
flights_form_round = Manche
flights_form_flyOff = Fly-off
flights_form_wind = Vent
flights_form_windUnit = m/s
flights_form_temperature = Température
flights_form_temperatureUnit = °C
flights_form_when = Date, lieu, modèle
flights_form_date = Date et heure
flights_form_noOffset = Le fuseau horaire du terrain n’est pas connu{"\u00a0"}: c’est l’heure de cet appareil.
flights_form_place = Lieu
flights_form_flown = Programme de ce vol
flights_form_open = Ouvrir son programme
flights_form_unreadable_not-a-number = Ce n’est pas un nombre.
flights_form_unreadable_not-a-time = Ce n’est pas un temps{"\u00a0"}: tapez des secondes comme 178, ou des minutes comme 2:58.
flights_form_unreadable_too-fine = { unreadable_too-fine }
flights_form_range = De { $min } à { $max } { $unit }.
flights_form_shortDt = Le DT de ce vol était de { $dt }.
flights_score_open = Feuille de résultats
flights_score_maximum = Maximum de chaque manche
flights_score_none = Sans maximum, chaque résultat compte en entier.
flights_score_maximumOf = Maximum{"\u00a0"}: { $round }
flights_score_counted = Compté (s)
flights_score_notCounted = non compté
flights_score_count = Compter celui-ci
flights_score_noRound = sans manche
flights_score_total = Total
flights_score_copy = Copier en texte
flights_csv_save = Enregistrer en tableau (CSV)
flights_csv_columns_date = Date
flights_csv_columns_time = Heure
flights_csv_columns_zone = Fuseau horaire
flights_csv_columns_place = Lieu
flights_csv_columns_model = Modèle
flights_csv_columns_setting = Programme
flights_csv_columns_timerClass = Classe de la minuterie
flights_csv_columns_memory = Mémoire
flights_csv_columns_dt = DT (s)
flights_csv_columns_motorStop = Arrêt moteur (s)
flights_csv_columns_wind = Vent (m/s)
flights_csv_columns_temperature = Température (°C)
flights_csv_columns_round = Manche
flights_csv_columns_result = Résultat (s)
flights_csv_columns_maximum = Maximum (s)
flights_csv_columns_note = Note
flights_section_all = Tous ses vols

## Values that are unusual, or cannot be written.

findings_time-not-whole = { unreadable_not-a-whole-number }
findings_time-out-of-range = La valeur doit être entre { $min } et { $max }.
findings_position-not-whole = { unreadable_not-a-whole-number }
findings_position-out-of-range = La valeur doit être entre { $min } et { $max }.
findings_throttle-not-whole = { unreadable_not-a-whole-number }
findings_throttle-out-of-range = La valeur doit être entre { $min } et { $max }.
findings_position-as-read = Valeur lue { $value }, au-dessus du dernier pas, { $max }. Elle reste telle quelle si vous ne la changez pas.
findings_time-falls = Ce temps vient avant celui de la fonction au-dessus ({ $previous }).
findings_time-repeats = Le même temps que la fonction au-dessus, { $previous }.
findings_position-never-reached = Le même temps que la fonction au-dessus, { $previous }. Les positions de la fonction au-dessus ne sont jamais atteintes.
findings_motor-stop-after-dt = Le moteur ne s’arrête qu’après DT ({ $dt }){"\u00a0"}: le modèle descend moteur en marche.
findings_motor-run-long = Le moteur tourne plus de { $limit }, la limite pour F1Q.
findings_time-outside-manual = La notice admet de { $min } à { $max }.
findings_time-too-fine = La notice indique des paliers de { $step }{"\u00a0"}: la minuterie arrondira peut-être.
findings_dt-short = Moins de { $limit }.
findings_dt-moves-nothing = Aucun servo ne bouge à DT{"\u00a0"}: la minuterie ne fait pas descendre le modèle.
findings_throttle-unusual = Plus de { $limit } est inhabituel. L’unité n’est pas connue.
findings_class-unknown = La classe «{"\u00a0"}{ $timerClass }{"\u00a0"}» n’est pas connue{"\u00a0"}: ses règles n’ont pas été contrôlées.

## Why a text in a field is no value.

unreadable_empty = Vide{"\u00a0"}: tapez une valeur.
unreadable_not-a-time = Ce n’est pas un temps{"\u00a0"}: tapez des secondes comme 12,5 ou des minutes comme 2:05.
unreadable_too-fine = Plus fin qu’un centième de seconde.
unreadable_not-a-whole-number = Il faut un nombre entier.
unreadable_ambiguous = Cela peut se lire de plusieurs façons{"\u00a0"}: choisissez-en une.

## For a page that cannot reach a timer here.

restWorks = Tout marche ici aussi, sauf la connexion.

## What an Android phone needs.

firstVersions_android = 148
firstVersions_androidBluetooth = 138
firstVersions_lastBluetoothOnly = 147
firstVersions_androidCable = 17
android = Chrome { firstVersions_android } ou plus récent ({ firstVersions_androidBluetooth } à { firstVersions_lastBluetoothOnly } en Bluetooth seulement){"\u00a0"}; un câble demande Android { firstVersions_androidCable }

## For every browser about which nothing more is known. docs/connection.md names the first versions.

unsupportedHere_title = Ce navigateur ne peut pas atteindre une minuterie.
unsupportedHere_advice = Sur un ordinateur, prenez un Chrome, Edge, Opera ou Firefox actuel{"\u00a0"}; sur un téléphone, Chrome sous Android. { restWorks }

## Replaces the sentence above where the browser's name tells more.

unsupported_brave_title = Brave n’atteint une minuterie que si vous l’autorisez.
unsupported_brave_advice = Ouvrez brave://flags/#brave-web-serial-api, choisissez Enabled et appuyez sur Relaunch. { restWorks }
unsupported_ios_title = Aucun navigateur d’iPhone ou d’iPad ne peut atteindre une minuterie.
unsupported_ios_advice = Prenez un ordinateur, ou Chrome sur un téléphone Android. { restWorks }
unsupported_android_title = { unsupportedHere_title }
unsupported_android_advice = Sous Android, prenez { android }. { restWorks }

## What a saved program held before it was saved over.

versions_title = Versions antérieures
versions_until = Jusqu’au{"\u00a0"}{ $when }
versions_changed =
    { $more ->
        [0] puis { $change }
        [one] puis { $change } et { $more }{"\u00a0"}autre
       *[other] puis { $change } et { $more }{"\u00a0"}autres
    }
versions_otherLayout = puis des valeurs pour une autre minuterie
versions_same = Le programme enregistré contient cela maintenant.
versions_goBack = Revenir à cette version

## Two programs side by side.

compare_title = Comparer
compare_open = Comparer…
compare_second = avec
compare_screen = À l’écran
compare_timer = Minuterie, { $memory }
compare_groups_now = Maintenant
compare_groups_settings = Programmes enregistrés
compare_setting = { $model } · { $name }
compare_backup = { $memory } · { $when }
compare_backupOf = { $model } · { $memory } · { $when }
compare_nothing = Cet appareil n’a pas d’autre programme de cette classe et de cette structure.
compare_take = Prendre
compare_takeOf = Prendre { $value } pour { $field }
compare_takeHint = «{"\u00a0"}{ compare_take }{"\u00a0"}» copie une valeur dans le programme à l’écran.

## How a backup differs from what its timer holds.

modelBackups_same = comme dans la minuterie ({ $when })
modelBackups_differs =
    { $count ->
        [one] { $count } valeur diffère de la minuterie ({ $when })
       *[other] { $count } valeurs diffèrent de la minuterie ({ $when })
    }
modelBackups_now = maintenant


## Undo, redo, and edits of many fields at once.

edits_redoButton = Refaire
edits_undo = Annuler{"\u00a0"}: { $step }
edits_redo = Refaire{"\u00a0"}: { $step }
edits_steps_change = changement ({ $what })
edits_steps_shift = décalage de { $by } dès { $what }
edits_steps_step-servo = { $what } décalé de { $steps }
edits_steps_step-servo-from = { $what } décalé de { $steps } dès { $from }
edits_steps_paste = collage de { $count }
edits_steps_fill = recopie vers le bas de { $count }
edits_steps_revert-all = rétablissement de tout
edits_steps_open = ouverture ({ $what })
edits_steps_keep-tried = conservation des positions essayées
edits_opened = «{"\u00a0"}{ $name }{"\u00a0"}»
edits_openedUnnamed = un autre programme
edits_refused_start = Le départ n’a pas de temps à changer.
edits_refused_later-out-of-range = Une fonction suivante sortirait des limites, { $min } à { $max }.
edits_refused_unreadable = Un texte qui n’est pas une valeur empêche cela. Corrigez-le d’abord.
edits_refused_interval-disagrees = Cet intervalle ne correspond pas aux temps des deux lignes.
edits_refused_no-place = Le programme n’a pas cette place.
edits_refused_twice = Cette place vient deux fois, avec des valeurs différentes.
edits_refused_too-large = Le tableau est trop grand{"\u00a0"}: { $cells } cellules au plus sont lues. Le reste a été laissé de côté.
edits_beforeLaunch = Ce serait avant le départ.
edits_nothingDone = Rien n’a été changé.
edits_cells =
    { $count ->
        [one] { $count } valeur
       *[other] { $count } valeurs
    }
edits_change = { $field }{"\u00a0"}: { $from } → { $to }
edits_field_putBack = Rétablir { $field }
edits_field_putBackTo = Rétablir { $field } à { $figure }
edits_sheet_title = Touches pour { $field }
edits_sheet_erase = Effacer le dernier chiffre
edits_sheet_putBack = Rétablir
edits_sheet_selectRange = Sélectionner une plage
edits_sheet_goTo = Aller à { $name }
edits_table_explain = Ce que sont les valeurs
edits_table_interval = Après
edits_table_countedFrom = depuis { $row }
edits_table_switch = Temps ou Après
edits_table_intervalOf = { $slot }, intervalle
edits_table_range_title = Plage sélectionnée
edits_table_range_pick = Touchez maintenant une autre cellule.
edits_table_range_size = { $cells }, { $columns }
edits_table_range_functions =
    { $count ->
        [one] { $count } fonction
       *[other] { $count } fonctions
    }
edits_table_range_rows =
    { $count ->
        [one] { $count } ligne
       *[other] { $count } lignes
    }
edits_table_range_columns =
    { $count ->
        [one] { $count } colonne
       *[other] { $count } colonnes
    }
edits_table_range_paste = Coller…
edits_table_range_fillDown = Recopier vers le bas
edits_table_range_clipboardClosed = Il n’y a rien à coller que cette page puisse voir. Touchez le premier champ et collez-y.
edits_table_tools = Outils{"\u00a0"}: { $name }
edits_stepServo_title = Toutes les positions de { $servo }
edits_stepServo_now = Maintenant { $position }
edits_stepServo_nowRange = Maintenant { $lowest } à { $highest }
edits_stepServo_by = Décalage, en pas
edits_stepServo_step = Décaler
edits_stepServo_which = Lesquelles
edits_stepServo_all = Toutes les fonctions
edits_stepServo_from = Dès { $slot }
edits_stepServo_stops =
    { $count ->
        [one] { $steps }{"\u00a0"}: { $what } s’arrête à { $at }.
       *[other] { $steps }{"\u00a0"}: { $what } s’arrêtent à { $at }.
    }
edits_shift_open = Décaler…
edits_shift_from =
    { $isLast ->
        [true] { $row }
       *[false] { $row } et toute la suite
    }
edits_shift_by = Décalage, en secondes
edits_shift_earlier = Plus tôt
edits_shift_later = Plus tard
edits_shift_moveDt = Décaler aussi DT
edits_shift_function = fonction { $number }
edits_shift_functionRange = fonctions { $first } à { $last }
edits_shift_functions = fonctions { $numbers }
edits_shift_moved =
    { $later ->
        [true] Décalé de { $time }{" "}s, plus tard
       *[false] Décalé de { $time }{" "}s, plus tôt
    }
edits_pasting_asks = Ces noms ne sont pas connus. Dites ce qu’ils signifient{"\u00a0"}:
edits_pasting_choose = Choisir
edits_pasting_leaveOut = Laisser de côté
edits_pasting_table = Ce qui va où
edits_pasting_lead =
    { $count ->
        [0] Cela ne change rien.
        [one] Cela change { $count } valeur.
       *[other] Cela change { $count } valeurs.
    }
edits_pasting_reading = { $field }{"\u00a0"}: «{"\u00a0"}{ $text }{"\u00a0"}» est lu comme { $time }.
edits_pasting_problems = Ceci ne peut pas être collé{"\u00a0"}:
edits_pasting_place = Ligne { $row }, colonne { $column } du texte copié
edits_pasting_problem = { $place }{"\u00a0"}: { $reason }
edits_pasting_problemOf = { $place }, «{"\u00a0"}{ $text }{"\u00a0"}»{"\u00a0"}: { $reason }
edits_pasting_apply = Coller
edits_presets_title = DT prédéfinis
edits_presets_use = DT { $time }
edits_presets_refused = Tapez des temps comme 20 s ou 2:30, jusqu’à 10:55 min, 24 au plus.
edits_fix = Mettre à { $value }
edits_fixOf = Mettre à { $value }{"\u00a0"}: { $field }

## The library as files: export, import, and the reminder to export.

files_export_all = Tout exporter…
files_export_one = Exporter…
files_export_downloaded = «{"\u00a0"}{ $name }{"\u00a0"}» va dans vos téléchargements{"\u00a0"}: { $what }. Regardez s’il y est.
files_export_without = sans { $kind }
files_export_kinds_models = modèles
files_export_kinds_settings = programmes
files_export_kinds_flights = vols
files_export_partly = «{"\u00a0"}{ $name }{"\u00a0"}» n’est pas complet. Il contient{"\u00a0"}: { $what }. Le navigateur ne peut pas lire en ce moment{"\u00a0"}: { $missing }. Fermez les autres onglets de cette page et exportez à nouveau.
files_export_and = { $first } et { $next }
files_export_tooLarge = La bibliothèque est trop grande pour un seul fichier. Exportez ses modèles un par un.
files_export_failed = Le fichier n’a pas pu être créé. Rechargez la page et réessayez.
files_import_button = Importer…
files_import_title = Importer { $name }
files_import_lead = Enregistré le { $date }. Contenu{"\u00a0"}: { $what }.
files_import_leadNothing = Enregistré le { $date }. Il ne contient rien.
files_import_ignored =
    { $count ->
        [one] { $count } entrée vient d’une version plus récente de cette page et est laissée de côté.
       *[other] { $count } entrées viennent d’une version plus récente de cette page et sont laissées de côté.
    }
files_import_nothing = Vous avez déjà tout cela.
files_import_differs = Ce qui diffère
files_import_ways_newer = Prendre le plus récent
files_import_ways_both = Conserver les deux
files_import_itself = le modèle lui-même
files_import_flightOf = vol ({ $day })
files_import_wayText_newer = Ce qui est plus récent ici, ou de la même date, reste.
files_import_wayText_both = Les deux restent. Celui du fichier reçoit un numéro après son nom.
files_import_unknownModel = Un modèle qui n’est pas ici
files_import_group_fresh = Nouveau{"\u00a0"}: { $what }
files_import_group_same = Identique{"\u00a0"}: { $what }
files_import_group_fileNewer = Plus récent dans le fichier{"\u00a0"}: { $what }
files_import_group_deviceNewer = Pas plus récent dans le fichier{"\u00a0"}: { $what }
files_import_group_fileName = { $file } (ici{"\u00a0"}: { $here })
files_import_take =
    { $count ->
        [0] Rien à importer
       *[other] Importer { $count }
    }
files_import_allStays = Rien dans le fichier n’est plus récent. Choisissez «{"\u00a0"}{ files_import_ways_both }{"\u00a0"}» pour l’importer aussi.
files_import_done = Importé de «{"\u00a0"}{ $name }{"\u00a0"}»{"\u00a0"}: { $what }.
files_import_undo = Annuler l’import
files_import_undone = L’import a été annulé. Les changements faits depuis restent.
files_refused_title = { $name } ne peut pas être importé
files_refused_nothing = Rien n’a été importé.
files_refused_again = Exportez à nouveau le fichier, ou demandez-en un nouveau à l’expéditeur.
files_refused_fault = Ligne{"\u00a0"}{ $line }{"\u00a0"}: trouvé { $found }.
files_refused_faultIn = Ligne{"\u00a0"}{ $line }, { $place }{"\u00a0"}: trouvé { $found }.
files_refused_wanted = Attendu{"\u00a0"}:
files_refused_place_entry =
    { $kind ->
        [models] Modèle «{"\u00a0"}{ $name }{"\u00a0"}»
        [settings] Programme «{"\u00a0"}{ $name }{"\u00a0"}»
       *[flights] Vol «{"\u00a0"}{ $name }{"\u00a0"}»
    }
files_refused_place_unnamed =
    { $kind ->
        [models] Modèle { $number } du fichier
        [settings] Programme { $number } du fichier
       *[flights] Vol { $number } du fichier
    }
files_refused_place_function = fonction { $number }
files_refused_damaged = Le fichier est endommagé ou incomplet.
files_refused_files_too-large = Le fichier est trop grand pour une bibliothèque.
files_refused_files_gone = Le fichier n’a pas pu être lu. Choisissez-le à nouveau.
files_refused_files_several = Importez un fichier à la fois.
files_refused_format = Ce n’est pas un fichier de bibliothèque de Sidus Timer.
files_refused_newer = Il a été créé par une version plus récente de cette page. Rechargez la page quand vous êtes en ligne.
files_reminder =
    { $changes ->
        [one] { $changes } changement de la bibliothèque n’est que sur cet appareil. Si vous perdez l’appareil, seul un fichier permet de le retrouver.
       *[other] { $changes } changements de la bibliothèque ne sont que sur cet appareil. Si vous perdez l’appareil, seul un fichier permet de les retrouver.
    }

## For the time before the other sentences are loaded.

first_failed = La page n’est pas complète. Y a-t-il du réseau{"\u00a0"}?
first_again = Recharger

## What a system shows of the installed page.

manifest_description = Règle les minuteries de vol libre Sidus F1Q, F1B et F1E{"\u00a0"}: lit ce qu’une minuterie contient, prend vos changements, les écrit, les relit et compare. Garde vos modèles et programmes sur cet appareil. Fonctionne sans réseau.
manifest_connect = Connecter une minuterie
manifest_connectShort = Connecter
manifest_connectWhat = L’accueil, avec Connecter sous la main
manifest_library = Bibliothèque
manifest_libraryWhat = Les modèles et leurs programmes
manifest_simulated = Minuterie simulée
manifest_simulatedWhat = L’accueil, avec les minuteries simulées sous la main
manifest_pictures_program = Le programme d’une minuterie, avec deux changements marqués
manifest_pictures_write = Ce qu’une écriture va changer, avant d’écrire
manifest_pictures_programPhone = Tout le programme sur un téléphone
manifest_pictures_writePhone = Ce qu’une écriture va changer, sur un téléphone

## The help inside the page.

guide_pages_checklist = Check-list
guide_pages_trouble = Problèmes
guide_pages_words = Valeurs
guide_pages_steps = Premiers pas
guide_nav = Pages d’aide

## What a new pilot is told.

firstSteps_1 = Lire{"\u00a0"}: appuyez sur «{"\u00a0"}{ header_connect }{"\u00a0"}», réveillez la minuterie, tenez la tête infrarouge tout près. Lire ne change rien et ne bouge rien.
firstSteps_2 = Écrire{"\u00a0"}: tapez les nouvelles valeurs, appuyez sur «{"\u00a0"}Écrire{"\u00a0"}», regardez chaque différence. «{"\u00a0"}Vérifié{"\u00a0"}» signifie{"\u00a0"}: la minuterie a été relue et contient ce que vous voulez.
firstSteps_3 = Voler{"\u00a0"}: en haut de la page se trouvent la mémoire du prochain vol et son DT. La page n’a pas besoin de réseau, et rien ne quitte cet appareil.

## The values of a program, with unit and range.

values_function_text = Une étape du vol{"\u00a0"}: à son temps, chaque servo va à sa position. Pour en sauter une, donnez-lui les positions de la fonction précédente.
values_function_range = En général le départ, neuf fonctions et DT.
values_time_text = Quand une fonction commence, compté à partir du départ. Tapez 12,5 ou 2:05. Pour F1B et F1E, on ne sait pas à partir de quand la minuterie compte.
values_time_range = Selon les notices. F1Q{"\u00a0"}: 0,1 à 99,9 s. F1B{"\u00a0"}: 0,01 à 9,99 s pour les fonctions 1 et 2, puis 0,1 à 99,9 s. F1E{"\u00a0"}: pas connu.
values_after_text = Le temps depuis la fonction précédente. Toutes les fonctions suivantes se décalent avec lui, DT non.
values_position_name = Position
values_position_text = Où se tient un servo. L’angle d’un pas dépend du servo et de la tringlerie{"\u00a0"}: essayez-le dans la vue «{"\u00a0"}{ views_names_bench }{"\u00a0"}».
values_position_range = 0 à 130 pas.
values_motorStop_text = F1Q{"\u00a0"}: quand le moteur s’arrête, compté à partir du départ. Aucun servo ne bouge avec lui.
values_motorStop_range = Selon la notice, 0,1 à 99,9 s, par paliers de 0,1 s.
values_dt_text = Le déthermaliseur{"\u00a0"}: quand il fait descendre le modèle, compté à partir du départ. En rouge s’il est plus court que votre limite.
values_dt_range = 1 à 720 s selon la notice. Plus de 10:55 min ne peut pas être envoyé.
values_idleThrottle_text = F1Q{"\u00a0"}: probablement la vitesse du moteur tant que l’interrupteur de départ est enfoncé.
values_idleThrottle_range = La page suppose 0 à 100. L’unité n’est pas connue.
values_memory_text = Une minuterie a plusieurs mémoires, chacune avec un programme. Celle qui est sélectionnée sert au prochain vol. Consulter une autre mémoire la sélectionne puis revient{"\u00a0"}; si cela est interrompu, la page dit laquelle servira peut-être au prochain vol.
values_memory_range = En général quatre, M1 à M4. Les minuteries plus anciennes en ont cinq.

## What a pilot checks before a flight.

checklist_lead = Cochez chaque point. Les coches valent pour un vol et ne sont pas conservées.
checklist_items_memory = La bonne mémoire servira au prochain vol.
checklist_items_dtTime = J’ai dit le temps du DT à voix haute.
checklist_items_surfaces = L’aile, le stabilisateur et la dérive tiennent bien et sont dans la bonne position.
checklist_items_battery = La batterie est chargée, et sa prise est enfoncée à fond.
checklist_items_dtSeen = J’ai vu le servo aller à la position DT.
checklist_items_radioDt = J’ai essayé le DT radio, s’il y en a un.
checklist_items_switch = J’ai appuyé cinq fois sur l’interrupteur de départ, et il est revenu à chaque fois.
checklist_items_propeller = L’hélice est bien fixée et tourne librement. Personne n’est devant elle.
checklist_known_now = Prochain vol{"\u00a0"}: { $memory }, DT{"\u00a0"}{ $dt } (lecture{"\u00a0"}: { $time }).
checklist_known_onceAt = À la dernière lecture ({ $time }){"\u00a0"}: { $memory }, DT{"\u00a0"}{ $dt }.
checklist_known_once = À la dernière lecture{"\u00a0"}: { $memory }, DT{"\u00a0"}{ $dt }.
checklist_known_not = On ne sait pas ce que contient { $memory }. Lisez cette mémoire avant de voler.
checklist_known_nothing = Aucune minuterie n’a été lue. Connectez-en une pour voir ici la mémoire du prochain vol et son DT.
checklist_known_unwritten =
    { $count ->
        [one] { $count } changement n’est pas encore dans la minuterie.
       *[other] { $count } changements ne sont pas encore dans la minuterie.
    }
checklist_left =
    { $count ->
        [one] Reste { $count } point
       *[other] Restent { $count } points
    }
checklist_done = Tout est coché. Bon vol.
checklist_again = Tout décocher

## Problems as a pilot sees them, and what to do.

troubles_symptoms_noAnswer_title = La minuterie ne répond pas
troubles_symptoms_noAdapter_title = La page ne trouve pas l’adaptateur
troubles_symptoms_refused_title = L’adaptateur ne s’ouvre pas
troubles_symptoms_wrongValues_title = Les valeurs semblent fausses
troubles_symptoms_wrongValues_steps_1 = Regardez en haut de la page{"\u00a0"}: quelle mémoire est affichée, et laquelle servira au prochain vol{"\u00a0"}?
troubles_symptoms_wrongValues_steps_2 = Appuyez sur «{"\u00a0"}{ program_read }{"\u00a0"}».
troubles_symptoms_wrongValues_steps_3 = Les temps diminuent-ils d’une ligne à l’autre{"\u00a0"}? La page demande alors comment les lire.
troubles_symptoms_wrongValues_steps_4 = Sur F1B et F1E, comparez les temps avec le programmateur.
troubles_symptoms_cutOff_title = L’écriture a été interrompue
troubles_symptoms_cutOff_steps_1 = Ne volez pas encore avec ce modèle. Connectez la minuterie{"\u00a0"}: la page la lit, puis propose de terminer l’écriture ou de réécrire les anciennes valeurs.
troubles_symptoms_cutOff_steps_2 = Ce que la minuterie contenait avant se trouve sous «{"\u00a0"}{ views_names_memories }{"\u00a0"}», «{"\u00a0"}{ backups_title }{"\u00a0"}».
troubles_symptoms_noDt_title = Le DT ne se déclenche pas, ou au mauvais moment
troubles_symptoms_noDt_steps_1 = Regardez en haut de la page{"\u00a0"}: là se trouvent la mémoire du prochain vol et son DT. Une autre mémoire a un autre DT.
troubles_symptoms_noDt_steps_2 = L’interrupteur de départ revient-il à chaque fois{"\u00a0"}? Tant qu’il est enfoncé, la séquence ne commence pas, et le DT ne se déclenche pas.
troubles_symptoms_noDt_steps_3 = La batterie est-elle chargée, sa prise enfoncée à fond{"\u00a0"}? Quand la minuterie ne tourne pas, le DT ne se déclenche pas.
troubles_symptoms_noDt_steps_4 = Tenez bien le modèle et appuyez sur la ligne DT dans la vue «{"\u00a0"}{ views_names_bench }{"\u00a0"}». Le servo va-t-il à la position DT, et libère-t-il ce qu’il retient{"\u00a0"}?
troubles_symptoms_noDt_steps_5 = Démontez l’hélice et laissez tourner la minuterie jusqu’à la fin. Ne volez pas avant d’avoir vu le servo bouger au temps du DT.
troubles_symptoms_noMove_title = Un servo ne bouge pas
troubles_symptoms_noMove_steps_1 = Tenez le modèle et appuyez, dans la vue «{"\u00a0"}{ views_names_bench }{"\u00a0"}», sur la ligne de la fonction où le servo doit bouger. Rien ne bouge{"\u00a0"}? Regardez la prise et la batterie. Il bouge là, mais pas en vol{"\u00a0"}? Il a la même position qu’à la fonction précédente.
troubles_symptoms_noMove_steps_2 = Va-t-il ailleurs que ne le dit le tableau{"\u00a0"}? Il se peut que certaines minuteries ne gardent une position que pour la fonction où sont les servos. La page propose alors de déplacer les servos pendant l’écriture.
troubles_symptoms_noMove_steps_3 = Bourdonne-t-il, ou s’arrête-t-il trop tôt{"\u00a0"}? La tringlerie le bloque peut-être{"\u00a0"}: essayez un mouvement plus petit.
troubles_symptoms_noMotor_title = Le moteur ne démarre pas
troubles_symptoms_noMotor_steps_1 = Après un vol, la minuterie verrouille le moteur. Pour le déverrouiller, tenez le modèle et gardez les mains loin de l’hélice{"\u00a0"}: elle peut démarrer. Maintenez ensuite enfoncé le bouton «{"\u00a0"}{ bench_unlock }{"\u00a0"}» dans la vue «{"\u00a0"}{ views_names_bench }{"\u00a0"}».
troubles_symptoms_noMotor_steps_2 = L’interrupteur de départ est-il revenu{"\u00a0"}? Tant qu’il est enfoncé, le moteur ne tourne qu’au ralenti.
troubles_symptoms_noMotor_steps_3 = L’arrêt moteur vient-il assez tard{"\u00a0"}? À 0,1 s, le moteur s’arrête dès qu’il a démarré.
troubles_symptoms_noLibrary_title = Mes modèles et programmes ne sont pas là
troubles_symptoms_noLibrary_steps_1 = Videz le champ de recherche, appuyez sur Archives.
troubles_symptoms_noLibrary_steps_2 = Chaque navigateur, profil et adresse a sa propre bibliothèque{"\u00a0"}; une fenêtre privée l’efface.
troubles_symptoms_noLibrary_steps_3 = Sur un autre appareil, ou si elle est perdue{"\u00a0"}: Importer, puis le fichier de votre dernier export.

## What to do, step by step, when a timer cannot be reached.

help_title = Que faire
help_steps_programs = Fermez les autres onglets et programmes qui utilisent l’adaptateur, comme Arduino IDE, PuTTY, un programme d’imprimante 3D ou un configurateur de drone.
help_steps_replug = Débranchez l’adaptateur, attendez cinq secondes, rebranchez-le. Si cela ne suffit pas, redémarrez l’ordinateur.
help_steps_cable = Branchez l’adaptateur directement, sans hub, et essayez un autre câble. Beaucoup de câbles USB ne font que charger.
help_steps_windows = Windows{"\u00a0"}: ouvrez le Gestionnaire de périphériques. Une marque jaune sur l’adaptateur signifie que son pilote manque{"\u00a0"}: connectez-vous à Internet et lancez Windows Update.
help_steps_mac = Mac{"\u00a0"}: autorisez l’accessoire quand le Mac le demande. Un ancien macOS a besoin du pilote du fabricant.
help_steps_linux = Linux ne vous laisse peut-être pas utiliser l’adaptateur. Exécutez ceci, puis fermez la session et rouvrez-la.
help_steps_linux-container = Le Linux d’un Chromebook a peut-être pris l’adaptateur. Désactivez l’adaptateur dans les Paramètres, sous Environnement de développement Linux, Gérer les appareils USB.
help_steps_android = Sous Android, prenez { android }. { restWorks }
help_steps_bluetooth = Bluetooth{"\u00a0"}: associez l’adaptateur dans les paramètres du système (code 1234 ou 0000), laissez-le allumé et proche, et coupez le Bluetooth des autres appareils qui l’utilisent.
help_steps_firefox-finds = Firefox ne trouve aucun adaptateur Bluetooth, et aucun adaptateur du tout s’il vient du magasin d’Ubuntu. Prenez Chrome.
help_steps_firefox-reload = Firefox garde un adaptateur qui a échoué. Rechargez cette page. Ce que vous avez tapé est conservé.
help_steps_switch = { link_stages_steps_switch }
help_steps_near = { link_stages_steps_near }
help_steps_battery = La batterie de la minuterie est-elle chargée et branchée{"\u00a0"}? Quand sa batterie est vide, une minuterie reste en position DT.
help_steps_restarts = Certains adaptateurs redémarrent chaque fois que leur port est ouvert (DTR les réinitialise) et n’entendent rien pendant quelques secondes. Si c’est le cas du vôtre, fixez son débit dans { views_names_settings }, «{"\u00a0"}{ ports_settings }{"\u00a0"}»{"\u00a0"}: le port n’est alors ouvert qu’une fois. La page elle-même laisse DTR tel que le navigateur le règle.
help_steps_usual-settings = Ouvrez { views_names_settings }, «{"\u00a0"}{ ports_settings }{"\u00a0"}», et appuyez sur «{"\u00a0"}{ ports_reset }{"\u00a0"}»{"\u00a0"}: la page trouve alors le débit toute seule.
help_steps_report = Si cela se reproduit{"\u00a0"}: { views_names_settings }, Expert, { views_names_line }, «{"\u00a0"}{ line_copyReport }{"\u00a0"}». Envoyez-le à{"\u00a0"}:
help_steps_address = Ouvrez cette adresse dans un onglet{"\u00a0"}:
help_page = Toutes les étapes, pour chaque système

## For when the browser does not store, or give back, what it should.

keeping_title = Ce navigateur ne conserve pas tout.
keeping_notKept = Ce que vous tapez, les sauvegardes et la trace d’une écriture interrompue ne durent que tant que cette page est ouverte. Exportez la bibliothèque. Fermez ensuite les autres onglets de cette page, ou libérez de la place sur cet appareil.
keeping_notKnown = Le navigateur ne dit pas s’il conserve ce que vous faites. Considérez que non, et exportez la bibliothèque.
keeping_oneTab = N’utilisez qu’un seul onglet de cette page.
keeping_emptied = Le navigateur a effacé ce qu’il conservait pour cette page. Exportez ce que vous voyez encore.
keeping_export = Exporter la bibliothèque…

## Stored data that cannot be read.

aside_title =
    { $count ->
        [one] { $count } fiche n’a pas pu être lue. Elle est mise de côté, pas effacée.
       *[other] { $count } fiches n’ont pas pu être lues. Elles sont mises de côté, pas effacées.
    }
aside_write = La trace d’une écriture interrompue en fait partie{"\u00a0"}: lisez la minuterie avant de voler.
aside_save = Enregistrer dans un fichier

## “2 models, 1 program”: only kinds that there are.

counted_models =
    { $count ->
        [one] { $count }{"\u00a0"}modèle
       *[other] { $count }{"\u00a0"}modèles
    }
counted_settings =
    { $count ->
        [one] { $count }{"\u00a0"}programme
       *[other] { $count }{"\u00a0"}programmes
    }
counted_flights =
    { $count ->
        [one] { $count }{"\u00a0"}vol
       *[other] { $count }{"\u00a0"}vols
    }
counted_backups =
    { $count ->
        [one] { $count }{"\u00a0"}sauvegarde
       *[other] { $count }{"\u00a0"}sauvegardes
    }

## What was deleted a moment ago.

removed = Supprimé{"\u00a0"}: { $what }.

## Deletes everything that this device keeps.

erase_open = Tout supprimer sur cet appareil…
erase_lead = Ceci supprime de ce navigateur tous les modèles, programmes, vols, sauvegardes, changements non écrits et choix de cette page. C’est irréversible. Les minuteries gardent ce qu’elles contiennent.
erase_uncertain = Une écriture a été interrompue, et on ne sait pas ce que contient la minuterie concernée. Sans la trace de cette écriture, cette page ne peut pas vous prévenir{"\u00a0"}: lisez la minuterie concernée avant de voler.
erase_start = Tout supprimer
erase_running = Suppression
erase_failed = Tout n’a pas pu être supprimé. Fermez les autres onglets de cette page et réessayez, ou supprimez ses données dans les paramètres du navigateur.

## For a page that is shown inside another page.

framed_title = Sidus Timer ne marche que dans son propre onglet{"\u00a0"}: une autre page pourrait cacher ce que vous voyez de votre minuterie.
framed_open = Ouvrir Sidus Timer dans son propre onglet

## What is known about the content of a timer, and what is not.

knowledge_title = Incertain
knowledge_uncertain = On ne sait pas ce que contient { $memory }{"\u00a0"}: { $values }.
knowledge_noFly = Ne volez pas avant de l’avoir lue.
knowledge_since = Écriture interrompue (début{"\u00a0"}: { $time }).
knowledge_thisMemory = la mémoire sélectionnée
knowledge_memoryOf = { $memory } ({ $timer })
knowledge_timer_here = { $name } { $firmware }
knowledge_timer_simulated = { $name } { $firmware } simulée
knowledge_otherTimer_here = autre { $name } { $firmware }
knowledge_otherTimer_simulated = autre { $name } { $firmware } simulée
knowledge_motorStop = arrêt moteur
knowledge_either = { $name } = { $before } ou { $goal }
knowledge_list =
    { $more ->
        [one] { $named }, et { $more }{"\u00a0"}autre{"\u00a0"}valeur est incertaine
       *[other] { $named }, et { $more }{"\u00a0"}autres{"\u00a0"}valeurs sont incertaines
    }
knowledge_and = { $first }, et { $next }
knowledge_connect = Connecter et lire
knowledge_forget = Oublier ceci…
knowledge_forgetSure = N’oubliez ceci que si vous avez lu la minuterie concernée ailleurs, ou si vous ne l’avez plus.
knowledge_forgetNow = L’oublier maintenant
knowledge_verified = Comme dans la minuterie (vérifié{"\u00a0"}: { $time })
knowledge_readAt = Comme dans la minuterie (lu{"\u00a0"}: { $time })
knowledge_lastReadAt = Comme à la dernière lecture ({ $time })
knowledge_lastRead = Comme à la dernière lecture
knowledge_ofSetting =
    { $changes ->
        [0] { $name }{"\u00a0"}: enregistré
        [one] { $name }{"\u00a0"}: { $changes } changement non enregistré
       *[other] { $name }{"\u00a0"}: { $changes } changements non enregistrés
    }
knowledge_changed = { $name }, modifié
knowledge_ofModel = { $name } ({ $model })
knowledge_made = Nouveau programme, encore dans aucune minuterie
knowledge_unknown = Contenu de { $memory } inconnu
knowledge_unfinished =
    { $count ->
        [one] { $count } champ n’a pas encore de valeur
       *[other] { $count } champs n’ont pas encore de valeur
    }
knowledge_hints_now = Les champs marqués diffèrent de ce que contient la minuterie.
knowledge_hints_onceAt = Les champs marqués diffèrent de la dernière lecture ({ $time }).
knowledge_hints_once = Les champs marqués diffèrent de la dernière lecture.
knowledge_marks_now = était { $value }
knowledge_marks_once = dernière lecture{"\u00a0"}: { $value }
knowledge_notCertain = , incertain à présent
knowledge_held_now = Dans la minuterie
knowledge_held_once = Dernière lecture

## Why a program of the library or from a link cannot be opened now.

obstacles_busy = Cette page lit, écrit ou cherche une minuterie. Attendez qu’elle ait fini.
obstacles_following = Les servos suivent. Arrêtez d’abord le suivi.
obstacles_not-fitting = { notFitting }

## Models and their saved programs.

library_unread = Le navigateur ne peut pas lire la bibliothèque en ce moment. Fermez les autres onglets de cette page et réessayez.
library_empty_title = Aucun modèle
library_empty_lead = Un modèle contient ses programmes, avec des noms et des notes. Ils ne sont conservés que sur cet appareil.
library_empty_hint = Créez un modèle, ou lisez une minuterie et enregistrez son programme.
library_search_label = Rechercher des programmes
library_search_nothing = Aucun programme ne contient tous ces mots.
library_models_title = Modèles
library_models_all = Tous les modèles
library_models_make = Nouveau modèle…
library_models_settings =
    { $count ->
        [one] { $count } programme
       *[other] { $count } programmes
    }
library_models_archive = Archives ({ $count })
library_models_archived = archivé
library_models_latest = Dernier changement
library_list_open = à l’écran
library_model_timerClass = Classe
library_model_noClass = Non indiquée
library_model_facts = Ce modèle
library_model_noSettings = Aucun programme.
library_model_servos = Servos
library_model_servosUnknown = Enregistrez d’abord un programme de ce modèle.
library_model_servoWay = { $low } à { $high } pas
library_model_archive = Archiver
library_model_unarchive = Sortir des archives
library_model_remove = Supprimer le modèle
library_model_withSettings =
    { $count ->
        [one] Son programme est supprimé avec lui. «{"\u00a0"}{ undo }{"\u00a0"}» fait revenir les deux.
       *[other] Ses { $count }{"\u00a0"}programmes sont supprimés avec lui. «{"\u00a0"}{ undo }{"\u00a0"}» fait tout revenir.
    }
library_setting_isOpen = À l’écran{"\u00a0"}: le regarder
library_setting_loadAgain =
    { $count ->
        [one] Rouvrir{"\u00a0"}: { $count } valeur revient
       *[other] Rouvrir{"\u00a0"}: { $count } valeurs reviennent
    }
library_setting_tags = Mots-clés, séparés par des virgules
library_setting_from_typed = saisi
library_setting_from_timer = lu dans une minuterie
library_setting_from_simulated = lu dans une minuterie simulée
library_setting_from_backup = venu d’une sauvegarde
library_setting_from_file = venu d’un fichier
library_setting_from_link = venu d’un lien
library_setting_origin = { $source }, { $time }
library_setting_notShown = Il n’a pas pu être ouvert. Réessayez.
library_setting_gone = Il n’est plus dans la bibliothèque.
library_save_open = Enregistrer…
library_save_over = Remplacer { $program }
library_save_undo = Annuler l’enregistrement{"\u00a0"}: { $name }
library_save_crossing = Ce sont des valeurs du modèle { $from }. Les enregistrer sous { $to }.
library_save_asNew = Enregistrer un nouveau…
library_save_taken = Il y a déjà un programme { $program }. Tapez un autre nom, ou{"\u00a0"}:
library_save_replace = Le remplacer. Ses valeurs restent comme version antérieure.
library_save_name =
    { $of ->
        [program] Nom du programme
       *[model] Nom du modèle
    }
library_save_namePlace = Par exemple{"\u00a0"}: fly-off, calme
library_save_notSavable = Un champ n’a pas de valeur. Corrigez-le d’abord.
library_save_state =
    { $changes ->
        [0] { $name }{"\u00a0"}: enregistré
        [one] { $name }{"\u00a0"}: { $changes } changement non enregistré
       *[other] { $name }{"\u00a0"}: { $changes } changements non enregistrés
    }
library_nameNeeded = Il faut un nom.

## The log of the line.

line_empty = Rien à afficher.
line_unused = Encore rien sur la liaison. Vous pouvez aussi charger une capture et la rejouer comme une minuterie.
line_all = Tout
line_out = Vers la minuterie
line_in = De la minuterie
line_damaged = Endommagé
line_request = { $name } · { $letters }
line_reply = { $name }, réponse · { $letters }
line_echo = { $name }, écho · { $letters }
line_unknown = Lettre inconnue { $letter }
line_names_GETTIMERS = Lire les temps
line_names_SETTIMERS = Écrire les temps
line_names_GETSERVOPOS = Lire les positions
line_names_SETSERVO = Écrire une position
line_names_MOVETOFUNC = Déplacer les servos
line_names_GETSWVER = Identifier
line_names_UNLOCK = Déverrouiller le moteur
line_names_JUMP2 = Sauter
line_names_GETMEMORY = Quelle mémoire
line_names_SETMEMORY = Sélectionner une mémoire
line_names_GETLOWRPM = Lire le ralenti
line_names_SETLOWRPM = Écrire le ralenti
line_rejected_noise = Endommagé{"\u00a0"}: bruit
line_rejected_length = Endommagé{"\u00a0"}: longueur impossible
line_rejected_terminator = Endommagé{"\u00a0"}: pas de fin là où il en faut une
line_rejected_checksum = Endommagé{"\u00a0"}: somme de contrôle fausse
line_rejected_silence = Endommagé{"\u00a0"}: coupé
line_error_framing = Erreur de liaison{"\u00a0"}: cadrage
line_error_parity = Erreur de liaison{"\u00a0"}: parité
line_error_break = Erreur de liaison{"\u00a0"}: break
line_error_overrun = Erreur de liaison{"\u00a0"}: débordement, des octets ont été perdus
line_error_other = Erreur de liaison d’un autre type
line_position = { $slot }, { $servo }{"\u00a0"}: { $steps } pas
line_motorStop = arrêt moteur { $time }
line_reserved = réservé { $time }
line_functions = fonctions { $times }
line_identity = { $name }, firmware { $firmware }, { $functions } et DT, { $memories }, { $servos }
line_memories =
    { $count ->
        [one] { $count } mémoire
       *[other] { $count } mémoires
    }
line_memoryUnsaid = Elle ne dit pas laquelle.
line_idleThrottle = { $value }, unité inconnue
line_idleThrottleUnsaid = Elle ne donne pas de valeur.
line_acknowledged = Confirmé.
line_unreadable_wrong-length = Son contenu est plus long ou plus court qu’il ne faut.
line_unreadable_unknown-command = On ne sait pas ce que cela signifie.
line_unreadable_unexpected-reply = Elle répond à une autre demande.
line_unreadable_bad-identity = Ce qu’elle dit de la minuterie ne peut pas être juste.
line_unreadable_identity-needed = Elle sera lisible une fois que la minuterie aura dit ce qu’elle est.
line_unreadable_out-of-range = Une de ses valeurs ne peut pas être juste.
line_unreadable_not-an-integer = { line_unreadable_out-of-range }
line_unreadable_wrong-count = { line_unreadable_out-of-range }
line_unreadable_wrong-type = { line_unreadable_out-of-range }
line_unreadable_unknown-word = Son contenu ne peut pas être lu.
line_unreadable_bad-capture = { line_unreadable_unknown-word }
line_unreadable_bad-file = { line_unreadable_unknown-word }
line_unreadable_bad-link = { line_unreadable_unknown-word }
line_unreadable_newer-version = { line_unreadable_unknown-word }
line_unreadable_too-large = { line_unreadable_unknown-word }
line_unreadable_duplicate = { line_unreadable_unknown-word }
line_goOn = Continuer
line_came =
    { $number ->
        [one] En pause. { $number } entrée depuis.
       *[other] En pause. { $number } entrées depuis.
    }
line_clear = Vider
line_unidentified = inconnu
line_load = Charger…
line_filter = Afficher
line_searchHint = nom ou hexa
line_counts_out = { $count } vers la minuterie
line_counts_in = { $count } de la minuterie
line_counts_damaged =
    { $count ->
        [one] { $count } endommagé
       *[other] { $count } endommagés
    }
line_counts_errors =
    { $count ->
        [one] { $count } erreur de liaison
       *[other] { $count } erreurs de liaison
    }
line_recording =
    { $entries ->
        [one] { $name }{"\u00a0"}: une capture de { $entries } entrée.
       *[other] { $name }{"\u00a0"}: une capture de { $entries } entrées.
    }
line_replay = La rejouer comme une minuterie
line_cannotReplay = Elle ne peut pas être rejouée{"\u00a0"}: la minuterie n’y dit jamais ce qu’elle est.
line_back = Revenir à la liaison en direct
line_noRecordingAt = Ligne { $line }{"\u00a0"}: attendu un temps en secondes, > ou <, et des octets en hexa.
line_noRecording = Ce fichier n’est pas une capture.
line_send_title = Envoyer une trame à la main
line_send_lead = La page ajoute la longueur et la somme de contrôle.
line_send_bytes = Lettre et données, en hexa
line_send_faults_hex = Tapez deux chiffres hexa pour chaque octet, 0 à 9 ou A à F.
line_send_faults_too-long = Une trame porte au plus 252 octets.
line_send_preview = Ce qui part
line_send_send = Envoyer…
line_send_confirmTitle = Envoyer cette trame à la minuterie{"\u00a0"}?
line_send_danger = Des servos peuvent bouger, l’hélice peut démarrer, et le contenu de la minuterie peut changer. La minuterie est ensuite lue à nouveau.
line_send_confirm = Oui, l’envoyer une fois
line_send_sending = Envoi
line_send_answered = Réponse{"\u00a0"}:
line_send_unanswered = Aucune réponse. Ce que la trame demandait s’est peut-être produit malgré tout.
line_copyReport = Copier le rapport

## From the ports to a timer that answers.

link_portNames_ftdi = Adaptateur FTDI
link_portNames_cp210x = Adaptateur CP210x (Silicon Labs)
link_portNames_ch340 = Adaptateur CH340 (WCH)
link_portNames_pl2303 = Adaptateur PL2303 (Prolific)
link_portNames_bluetooth = Bluetooth
link_portNames_usb = Adaptateur USB
link_portNames_other = Port série
link_stages_choosing = Choisissez l’adaptateur de la minuterie
link_stages_openingLong_title = L’adaptateur est long à s’ouvrir
link_stages_openingLong_advice = Bluetooth{"\u00a0"}: allumez l’adaptateur, tout près. Câble{"\u00a0"}: débranchez-le et rebranchez-le.
link_stages_asking = Interrogation à { $rate } bauds.
link_stages_noAnswer = Pas de réponse depuis { $seconds } s. Cette page continue d’interroger et reprend toute seule.
link_stages_open = L’adaptateur est ouvert
link_stages_steps_switch = Réveillez la minuterie{"\u00a0"}: appuyez brièvement sur son interrupteur
link_stages_steps_near = Tenez la tête infrarouge à moins de 20 cm, à l’abri du soleil
link_stages_steps_other = La minuterie est-elle sur un autre adaptateur{"\u00a0"}?
link_refused = La page réessaie pendant 15 secondes. Un autre programme occupe peut-être l’adaptateur.
link_heard_title = On entend quelque chose, mais aucune minuterie ne répond.
link_heard_advice = Réveillez la minuterie et rapprochez la tête infrarouge, à l’abri du soleil, ou choisissez un autre adaptateur.
link_slow_title = Une minuterie répond, mais trop lentement.
link_slow_advice = Ses octets arrivent un par un à { $rate } bauds, avec des pauses si longues qu’aucune réponse n’est complète à temps. Cette page ne peut pas la lire. Essayez un autre adaptateur, ou un câble au lieu du Bluetooth.
link_itSaid = Reçu{"\u00a0"}: { $bytes } («{"\u00a0"}{ $text }{"\u00a0"}»).
link_trySelectBare = Essayer sans somme de contrôle correcte
link_lost_title = La connexion avec l’adaptateur est perdue.
link_lost_advice = Branchez-le ou rapprochez-le{"\u00a0"}: la page reprend toute seule. Ce que vous avez tapé est conservé.
link_status_off = Non connecté
link_status_opening = Connexion
link_status_searching = Recherche de la minuterie
link_status_away = Connexion perdue
link_status_closing = Déconnexion

## The known ports, and how they are opened.

ports_title = Adaptateurs connus
ports_forget = Oublier
ports_settings = Paramètres série
ports_settingsHint = Seulement pour un adaptateur particulier. La page trouve le débit toute seule.
ports_rate = Débit
ports_findRate = Le trouver
ports_baud = { $rate } bauds
ports_parity = Parité
ports_parities_none = Aucune
ports_parities_even = Paire
ports_parities_odd = Impaire
ports_stopBits = Bits d’arrêt
ports_dtr = DTR
ports_rts = RTS
ports_signals_leave = Selon le navigateur
ports_signals_on = Activé
ports_signals_off = Désactivé
ports_reset = Paramètres habituels

## What is known about the connected timer. Its numbers are in the report.

aboutTimer_title = Cette minuterie
aboutTimer_damage = Dommages vus sur la liaison
aboutTimer_crowd = Une autre minuterie ou un programmateur est peut-être dans le faisceau. Depuis, deux lectures doivent concorder.
aboutTimer_found = Ce qu’elle a fait autrement
aboutTimer_nothingFound = Rien jusqu’ici{"\u00a0"}: elle a fait tout ce qui a été demandé, de la façon habituelle.
aboutTimer_quirkNames_timers-reply-66 = Elle répond avec la lettre d’une autre commande.
aboutTimer_quirkNames_unlock-reply-6a = { aboutTimer_quirkNames_timers-reply-66 }
aboutTimer_quirkNames_memory-unknown = Elle ne dit pas quelle mémoire est sélectionnée.
aboutTimer_quirkNames_memory-impossible = { aboutTimer_quirkNames_memory-unknown }
aboutTimer_quirkNames_bare-checksum = Pour le ralenti, elle ne répond pas comme d’habitude.
aboutTimer_quirkNames_times-big-endian = Ses temps diminuent. En inversant les deux octets de chacun, ils augmenteraient.
aboutTimer_quirkNames_servo-first = À l’écriture d’une position, elle prend le servo avant la fonction.
aboutTimer_quirkNames_servo-unanswered = Elle n’a pas répondu à l’écriture d’une position.
aboutTimer_quirkNames_times-rounded = Elle arrondit les temps.
aboutTimer_quirkNames_memories-from-one = Elle compte ses mémoires à partir de 1.
aboutTimer_quirkNames_positions-unchanged = Elle a confirmé des positions mais ne les a pas gardées.
aboutTimer_quirkNames_echo = L’adaptateur renvoie ce qu’on lui envoie.
aboutTimer_quirkNames_idle-throttle-unanswered = { aboutTimer_quirkNames_bare-checksum }
aboutTimer_quirkNames_identity-unusual = Ce qu’elle dit d’elle-même contient des octets inconnus.
aboutTimer_quirkNames_idle-throttle-malformed = { aboutTimer_quirkNames_bare-checksum }
aboutTimer_quirkNames_replies-alike = Ses réponses à certaines demandes sont endommagées, chacune de la même façon.
aboutTimer_assumed = Différences connues
aboutTimer_assumedHint = Retenues pour cet adaptateur et ce type de minuterie.
aboutTimer_forget = Oublier les différences connues
aboutTimer_assumptions_bigEndianTimes = Les deux octets de chaque temps sont inversés
aboutTimer_assumptions_servoFirst = { aboutTimer_quirkNames_servo-first }
aboutTimer_assumptions_memoriesFromOne = { aboutTimer_quirkNames_memories-from-one }
aboutTimer_assumptions_bareChecksumRequests = «{"\u00a0"}Sélectionner une mémoire{"\u00a0"}» et «{"\u00a0"}Écrire le ralenti{"\u00a0"}» sont envoyés sans somme de contrôle correcte
aboutTimer_assumptions_positionsNeedMove = Les positions ne sont gardées qu’à la fonction où sont les servos

## Which memory flies next, and what is known about the others.

nextFlight_badge = prochain vol
nextFlight_onScreen = Voici { $memory }.
nextFlight_named = { $memory }, prochain vol
nextFlight_other = Prochain vol{"\u00a0"}: { $memory }.
nextFlight_last = À la dernière réponse de la minuterie, { $memory } était sélectionnée. Elle servira au prochain vol, si rien d’autre n’a changé cela.
nextFlight_original = À la connexion, c’était { $original }.
nextFlight_originalUnknown = On ne sait pas laquelle c’était à la connexion.
nextFlight_unknown = On ne sait pas quelle mémoire servira au prochain vol.
nextFlight_asked = { $memory } a été sélectionnée en dernier.
nextFlight_back = Revenir à { $original }
nextFlight_leaving_title = Avant de déconnecter
nextFlight_leaving_back = Revenir à { $original } et déconnecter
nextFlight_leaving_failed = La minuterie n’est pas revenue à { $original }. Elle est toujours connectée.

## The last reading of a memory that is not current.

look_read = { $memory } (lue{"\u00a0"}: { $time })
look_notRead = { $memory } n’a pas été lue
look_either = Soit
look_or = ou
look_lead = Pour consultation seulement. Prochain vol{"\u00a0"}: { $current }.
look_edit = Modifier { $memory }
look_look = Consulter { $memory }
look_hint = Ceci sélectionne { $memory }, la lit et revient à { $current }.
look_fly = Choisir { $memory } pour le vol
look_show = Afficher { $memory }

## Jobs over several memories, and the backups.

memories_copy = Copier { $from } vers { $to }
memories_restore = Restaurer une sauvegarde
memories_restoreAll = Restaurer les { $count }…
memories_plans_screen =
    { $keepsThrottle ->
        [true] { $to } contiendra les temps et positions à l’écran. Ce que { $to } contient maintenant est d’abord sauvegardé. Le ralenti reste tel quel.
       *[false] { $to } contiendra les temps et positions à l’écran. Ce que { $to } contient maintenant est d’abord sauvegardé.
    }
memories_plans_copy = { $to } contiendra les temps et positions de { $from }, lus à l’instant. Ce que { $to } contient maintenant est d’abord sauvegardé.
memories_plans_restore = Ceci écrit dans { $names } ce qui a été sauvegardé ({ $time }). Ce qui s’y trouve maintenant est d’abord sauvegardé.
memories_atEnd = À la fin, { $current } redevient la mémoire du prochain vol.
memories_refused = Rien ne peut être écrit dans { $memory }{"\u00a0"}: aucun logiciel ne peut envoyer ces valeurs.
memories_untouched = Rien n’a été écrit dans { $memory }.
memories_stopped = Ce qui n’a pas encore été écrit est resté comme avant.

## All memories of a timer at a glance.

overview_readAll = Tout lire et conserver
overview_copyTo = Copier vers…
overview_compareWith = Comparer avec { $memory }
overview_readAt = lue{"\u00a0"}: { $time }
overview_notCertain = Incertain{"\u00a0"}: une écriture dans cette mémoire a été interrompue. Affichée comme avant cette écriture.
overview_edited = Affichée et copiée telle qu’elle est dans la minuterie, sans vos changements.
overview_same = Elles contiennent la même chose.
overview_differs =
    { $count ->
        [one] { $count } valeur diffère.
       *[other] { $count } valeurs diffèrent.
    }

## How the timer writes its times: the question that no reading can answer.

byteOrder_title = Les temps de cette minuterie diminuent d’une ligne à l’autre.
byteOrder_advice = Ils augmenteraient si les deux octets de chaque temps étaient inversés. Comparez avec ce que vous savez de la minuterie, et choisissez avant d’écrire.
byteOrder_keep = Ils sont justes comme affichés
byteOrder_exchange = Les inverser et relire

## Why there is no connection.

connection_unsupported_title = { unsupportedHere_title }
connection_unsupported_advice = { unsupportedHere_advice }
connection_insecure_title = Le navigateur n’autorise pas les ports série ici.
connection_insecure_advice = { restWorks }
connection_policy_title = Le serveur de cette page interdit les ports série.
connection_policy_advice = { restWorks }
connection_nothing-chosen_title = Aucun adaptateur n’a été choisi.
connection_nothing-chosen_advice = Appuyez sur «{"\u00a0"}{ header_connect }{"\u00a0"}» et choisissez l’adaptateur. S’il n’est pas dans la liste, les étapes ci-dessous aident.
connection_not-allowed_title = { connection_insecure_title }
connection_not-allowed_advice = Autorisez les ports série pour cette page dans les paramètres du navigateur, puis appuyez à nouveau sur «{"\u00a0"}{ header_connect }{"\u00a0"}».
connection_busy_title = L’adaptateur ne s’ouvre pas.
connection_busy_advice = Le plus souvent, un autre programme ou onglet l’occupe. Fermez-le, puis appuyez à nouveau sur «{"\u00a0"}{ header_connect }{"\u00a0"}».
connection_bad-settings_title = L’adaptateur n’accepte pas ces paramètres.
connection_bad-settings_advice = { help_steps_usual-settings }
connection_unplugged_title = L’adaptateur est injoignable.
connection_unplugged_advice = Débranchez-le, rebranchez-le et appuyez sur «{"\u00a0"}{ header_connect }{"\u00a0"}». Ce que vous avez tapé est conservé.
connection_bad-reply_title = { link_heard_title }
connection_bad-reply_advice = { link_heard_advice }
connection_lost_title = { connection_unplugged_title }
connection_lost_advice = { connection_unplugged_advice }

## Why a job with the timer has ended.

timer_no-answer_title = La minuterie n’a pas répondu.
timer_no-answer_advice = Appuyez brièvement sur l’interrupteur de la minuterie, tenez la tête infrarouge à moins de 20 cm de la minuterie et réessayez. Ce que vous avez tapé est conservé.
timer_bad-reply_title = La réponse de la minuterie ne peut pas être juste.
timer_bad-reply_advice = Réessayez. Si cela se reproduit{"\u00a0"}: { views_names_settings }, Expert, { views_names_line }, «{"\u00a0"}{ line_copyReport }{"\u00a0"}».
timer_unstable_title = La liaison est trop bruitée pour qu’on s’y fie.
timer_unstable_advice = Rapprochez la tête infrarouge, à l’abri du soleil, et réessayez.
timer_crowded_title = Il y a peut-être plus d’une minuterie dans le faisceau.
timer_crowded_advice = Éloignez les autres minuteries et programmateurs, et relisez.
timer_other-memory_title = La mémoire sélectionnée n’est pas celle de l’écran.
timer_other-memory_advice = Relisez avant d’écrire.
timer_memory-unknown_title = Cette minuterie ne dit pas quelle mémoire est sélectionnée.
timer_memory-unknown_advice = Cette page ne peut donc pas consulter une autre mémoire et revenir. Vous pouvez lire et écrire celle qui est sélectionnée.
timer_memory-left_title = Le prochain vol se fera peut-être avec une autre mémoire.
timer_memory-left_advice = Cette page n’a pas pu revenir à la mémoire qui était sélectionnée. Connectez à nouveau la minuterie et choisissez la bonne mémoire pour le prochain vol avant de voler.
timer_other-timer_title = Ce n’est pas la minuterie qui a répondu avant.
timer_other-timer_advice = La page la lit. Regardez ce qu’elle contient avant d’écrire.
timer_stale_title = La minuterie ne contient pas ce qui était affiché.
timer_stale_advice = Rien n’a été écrit. Regardez ce qu’une écriture changerait maintenant.
timer_changed_title = La minuterie contient d’autres valeurs qu’avant.
timer_changed_advice = Autre chose l’a changée, ou c’est une autre minuterie. Vos changements sont conservés{"\u00a0"}: regardez la différence avant d’écrire.
timer_stood-still_title = Cette page s’est figée pendant l’opération.
timer_stood-still_advice = Plus rien n’a été envoyé ensuite{"\u00a0"}: une autre minuterie est peut-être là maintenant. Relisez.
timer_too-slow_title = Cette minuterie répond trop lentement.
timer_too-slow_advice = Ses réponses prennent plus de 3 secondes, cette page ne peut donc pas savoir à quelle demande chacune répond. Plus rien n’a été envoyé ensuite. Essayez un autre adaptateur, ou un câble au lieu du Bluetooth.
timer_undecided_title = { byteOrder_title }
timer_undecided_advice = { byteOrder_advice }
timer_serious_title = Les contrôles ont trouvé quelque chose de grave.
timer_serious_advice = { timer_stale_advice }
timer_busy_title = Quelque chose sur cette page ou cet ordinateur utilise l’adaptateur.
timer_busy_advice = Rien n’a été envoyé. Déconnectez la minuterie et reconnectez-la. Ce que vous avez tapé est conservé.
timer_port-lost_title = { link_lost_title }
timer_port-lost_advice = { link_lost_advice }
timer_aborted_title = Arrêté.
timer_aborted_advice = Relisez pour voir ce que contient la minuterie.
timer_closed_title = Déconnecté.
timer_closed_advice = Appuyez sur «{"\u00a0"}{ header_connect }{"\u00a0"}» pour continuer. Ce que vous avez tapé est conservé.

## Replies that are no noise, which is random.

alike_title = Chaque réponse à { $request } est endommagée de la même façon.
alike_advice = Ce n’est pas du bruit{"\u00a0"}: la minuterie ou son adaptateur forme ces réponses d’une façon inconnue. Activez Expert dans les paramètres, ouvrez { views_names_line } et appuyez sur «{"\u00a0"}{ line_copyReport }{"\u00a0"}». Envoyez le rapport aux responsables du projet (github.com/sidus-timer/sidus-timer/issues).
alike_part = Pour consultation seulement{"\u00a0"}: { $values }. Tout le reste est inconnu.

## Messages that are not about errors.

notes_back_title = Vos changements sont revenus.
notes_back_advice = Comparez-les avec ce que contient la minuterie, puis écrivez-les ou annulez-les.
notes_back-uncertain_title = { notes_back_title }
notes_back-uncertain_advice = On ne sait pas s’ils ont été écrits. Connectez la minuterie et lisez-la avant de voler.
notes_moved_title = { timer_changed_title }
notes_moved_advice = { timer_changed_advice }
notes_timer-moved_title = { timer_changed_title }
notes_timer-moved_advice = { timer_changed_advice }
notes_kept_title = Vos changements sont conservés sur cet appareil.
notes_kept_advice = Ils ne correspondent pas à ce qui vient d’être lu. Ils reviennent quand vous relisez la mémoire d’où ils viennent{"\u00a0"}; l’accueil les liste aussi.
notes_other-kind_title = Une minuterie d’un autre type est là maintenant.
notes_other-kind_advice = { timer_other-timer_advice }
notes_write-completed_title = L’écriture interrompue est complète.
notes_write-completed_advice = La minuterie a été relue et contient tout ce qui devait être écrit.
notes_nothing-written_title = { write_refused }
notes_nothing-written_advice = {""}
notes_not-backed-up_title = { write_unkept_title }
notes_not-backed-up_advice = { keeping_notKept }
notes_select-unanswered_title = La minuterie n’a pas répondu à la sélection d’une mémoire.
notes_select-unanswered_advice = Elle répond à d’autres demandes. Réessayez, ou envoyez la demande sans somme de contrôle correcte.
notes_backed-up_title = Toutes les mémoires ont été lues, et une sauvegarde de chacune est conservée.
notes_backed-up_advice = {""}
notes_strays_title = { timer_crowded_title }
notes_strays_advice = { timer_crowded_advice }
notes_made-laid_title = Le tableau montre votre programme, pas ce que contient la minuterie.
notes_made-laid_advice = Rien n’a été écrit. Ce qui diffère est marqué. «{"\u00a0"}{ undo }{"\u00a0"}» montre ce que contient la minuterie.
notes_unexpected_title = Un problème est survenu dans cette page.
notes_unexpected_advice = Plus rien n’a été envoyé ensuite. Rechargez la page. Ce que vous avez tapé est conservé.

## The flight of the program, and what the servos of the model move.

preview_title = Aperçu du vol
preview_guessed = Pas à l’échelle.
preview_nameServos = Nommer les servos…
preview_play = Animer
preview_speed = Vitesse
preview_time = Temps du vol
preview_launch = Départ
preview_at = { $what } à { $time }
preview_sketch = Le modèle vu de côté, et sa dérive vue de dessus
preview_motor_true = Montée, moteur en marche
preview_motor_false = Plané, moteur arrêté
preview_flies = En vol
preview_comesDown = DT{"\u00a0"}: le modèle descend
preview_duties_rudder = Dérive
preview_duties_tailplane = Stabilisateur
preview_duties_wing = Aile
preview_duties_release = Disque ou fil de DT
preview_duties_other = Autre chose
preview_duties_none = Non utilisé
preview_naming_lead = Ce que chaque servo actionne, et entre quels pas. Haut et bas désignent le bord de fuite.
preview_naming_duty = { $servo } actionne
preview_naming_name = Nom de ce que { $servo } actionne
preview_naming_low = { $servo }, une extrémité en pas
preview_naming_high = { $servo }, autre extrémité en pas
preview_naming_from = de
preview_naming_to = à
preview_naming_sense = { $servo }, effet des pas croissants
preview_naming_otherSense_false = pas croissants{"\u00a0"}: haut
preview_naming_otherSense_true = pas croissants{"\u00a0"}: bas
preview_naming_rudderSense_false = pas croissants{"\u00a0"}: droite
preview_naming_rudderSense_true = pas croissants{"\u00a0"}: gauche

## The sheet of a program.

print_paper = Papier
print_what = Sur la feuille
print_parts_lines = Lignes à remplir
print_parts_code = Code QR
print_nothing = Choisissez des programmes de la bibliothèque, ou ouvrez-en un.
print_choose = Programmes à imprimer{"\u00a0"}: { $chosen }
print_clear = Tout retirer
print_simulated = minuterie simulée
print_warnings = À regarder avant de voler
print_notes = Notes
print_codeHint = L’appareil photo d’un téléphone ouvre ce programme, sans sa note.
print_unfinished =
    { $count ->
        [one] { $count } champ n’a pas encore de valeur{"\u00a0"}: la dernière est imprimée
       *[other] { $count } champs n’ont pas encore de valeur{"\u00a0"}: la dernière est imprimée
    }
print_printed = Imprimé le { $date }

## The model in the strip.

recognition_which = Quel modèle{"\u00a0"}?
recognition_change = Modèle { $model }{"\u00a0"}: dire quel modèle c’est

## A memory with the pilot's name for it: M2 “fly-off”.

memoryNames_named = { $memory } «{"\u00a0"}{ $name }{"\u00a0"}»

## What an earlier job left behind on a timer.

recovery_title = Une écriture antérieure a été interrompue.
recovery_when = Début d’une écriture dans { $memory }{"\u00a0"}: { $time }.
recovery_nothing =
    { $missing ->
        [one] La minuterie contient ce qu’elle contenait avant{"\u00a0"}: rien n’a été écrit, { $missing } changement manque.
       *[other] La minuterie contient ce qu’elle contenait avant{"\u00a0"}: rien n’a été écrit, { $missing } changements manquent.
    }
recovery_part =
    { $missing ->
        [one] La minuterie contient { $values } de cette écriture{"\u00a0"}; { $missing } valeur est encore comme avant.
       *[other] La minuterie contient { $values } de cette écriture{"\u00a0"}; { $missing } valeurs sont encore comme avant.
    }
recovery_foreign =
    { $count ->
        [one] { $count } valeur dans la minuterie n’est ni l’ancienne ni celle de cette écriture. Est-ce une autre minuterie, ou quelque chose d’autre l’a-t-il changée{"\u00a0"}?
       *[other] { $count } valeurs dans la minuterie ne sont ni les anciennes ni celles de cette écriture. Est-ce une autre minuterie, ou quelque chose d’autre les a-t-il changées{"\u00a0"}?
    }
recovery_sure = Cette page ne peut pas distinguer des minuteries du même type. Ne continuez que si c’est la minuterie de cette écriture.
recovery_finish = Terminer l’écriture…
recovery_goBack = Réécrire les anciennes valeurs…
recovery_leave = Laisser tel quel
recovery_otherTimer = C’est une autre minuterie
recovery_sameTimer = C’est la même minuterie{"\u00a0"}: montrer ce qui devait être écrit
recovery_compare = Comparer
recovery_before = Avant
recovery_elsewhere = Une écriture dans { $memory } d’une minuterie de ce type a été interrompue. Lisez { $memory } pour voir ce qu’elle contient.
recovery_left = Le travail sur plusieurs mémoires a été interrompu. La mémoire du prochain vol est maintenant { $current }. Avant, c’était { $original }.
recovery_mayFly = Le prochain vol se fera peut-être avec { $memory }{"\u00a0"}: sa sélection a été interrompue.
recovery_mayNotFly = Le travail sur plusieurs mémoires a été interrompu. Le prochain vol se fera peut-être avec une autre mémoire que { $original }.
recovery_unknownMemory = une mémoire inconnue

## The backups.

backups_title = Sauvegardes
backups_empty = Avant chaque écriture, cette page conserve ici ce que contient la minuterie.
backups_reasons_write = avant une écriture
backups_reasons_memories = toutes les mémoires

## How the page looks.

theme_title = Couleurs
theme_names_system = Système
theme_names_light = Clair
theme_names_dark = Sombre
theme_names_sun = Soleil

## The settings of the page.

settings_look = Apparence
settings_expert = Expert{"\u00a0"}: afficher la liaison
settings_expertHint = La liaison montre chaque octet entre cette page et la minuterie. Le banc propose un saut qui n’est pas documenté.
settings_kept = Ce que cet appareil conserve

## A saved program as a link and a QR code, and back.

share_offer_lead = Le lien contient tout le programme. Rien n’est envoyé à un serveur.
share_offer_link = Lien
share_offer_copy = Copier le lien
share_offer_scan = Dirigez l’appareil photo de l’autre appareil vers ce code, ou envoyez le lien.
share_offer_qr = Code QR de «{"\u00a0"}{ $name }{"\u00a0"}»
share_offer_cut = La fin de la note ne tient pas dans le code QR. Le lien contient toute la note.
share_offer_tooLong = Trop long pour un code QR. Envoyez le lien.
share_received_title = Un programme reçu par un lien
share_received_lead = Pour l’instant, cette page ne fait que l’afficher. Rien n’est conservé, et rien n’est écrit dans une minuterie.
share_received_known = La bibliothèque a déjà ces valeurs{"\u00a0"}: { $name }.
share_received_modelChoice = Le conserver sous
share_received_newModel = Nouveau modèle «{"\u00a0"}{ $name }{"\u00a0"}»
share_received_keep = Conserver dans la bibliothèque
share_received_discard = Ne pas conserver
share_received_unwritten = Ce que vous avez tapé est conservé{"\u00a0"}: «{"\u00a0"}{ undo }{"\u00a0"}», ou l’accueil, le fait revenir.
share_damaged_title = Ce lien ne peut pas être lu.
share_damaged_bad = Il est coupé ou endommagé, ou ne vient pas de cette page. Redemandez-le.
share_paste_title = Coller un lien…
share_paste_lead = L’appareil photo d’un téléphone ouvre un code QR tout seul. Ici, vous pouvez coller un lien.
share_paste_show = Afficher
share_paste_notLink = Ce n’est pas un lien vers un programme.

## A DT for trimming that is about to be flown. The page asks before the pilot disconnects, and at a contest round.

shortDt_held = Le DT de { $memory } est de { $dt }.
shortDt_heldHere = Le DT est de { $dt }.
shortDt_ask =
    { $remembered ->
        [true] Le rétablir à { $back }{"\u00a0"}?
       *[false] Le mettre à { $back }{"\u00a0"}?
    }
shortDt_putBack =
    { $remembered ->
        [true] Rétablir DT à { $back }…
       *[false] Mettre DT à { $back }…
    }
shortDt_disconnect = Déconnecter ainsi{"\u00a0"}: { $memory }, DT{"\u00a0"}{ $dt }
shortDt_disconnectHere = Déconnecter ainsi{"\u00a0"}: DT{"\u00a0"}{ $dt }
shortDt_blocked = Quelque chose que vous avez tapé ne peut pas encore être écrit. Corrigez-le avant de rétablir DT.
shortDt_settings_limit = Un DT est court en dessous de
shortDt_settings_hint = Un DT plus court est en rouge, et la page pose la question avant que vous déconnectiez. Si la limite est de 0 s, elle ne la pose jamais.

## The start, before anything was read.

start_title = Réglez votre minuterie Sidus
start_lead = Lisez ce qu’elle contient, changez-le, écrivez-le et voyez-le vérifié. Rien ne quitte cet appareil.
start_adapter = Branchez l’adaptateur
start_firefox = Firefox demande d’abord une autorisation, puis le port à chaque chargement de cette page.
start_android = Un téléphone se connecte par Bluetooth{"\u00a0"}; un câble demande Android { firstVersions_androidCable } et Chrome { firstVersions_android }.
start_readyOffline = Prêt hors ligne
start_install = Installer
start_picture_example = Exemple{"\u00a0"}: une F1Q
start_picture_kept = Conservé{"\u00a0"}: { $time }
start_models_title = Mes modèles
start_models_none = Conservez les programmes de chaque modèle, avec des notes.
start_models_programs =
    { $count ->
        [one] { $count } programme
       *[other] { $count } programmes
    }
start_models_library = Ouvrir la bibliothèque
start_programs_title = Non terminés
start_programs_made = { $timer }, nouveau
start_programs_changesOf = { $timer }, changements
start_programs_sure = Le supprimer définitivement{"\u00a0"}?
start_simulatedTitle = Pas de minuterie sous la main{"\u00a0"}?
start_simulatedLead = Une minuterie simulée répond comme une vraie, octet par octet.
start_simulated = Essayer une { $name } simulée
start_backups =
    { $count ->
        [one] { $count } sauvegarde, conservée avant une écriture. La dernière{"\u00a0"}: { $last }.
       *[other] { $count } sauvegardes, conservées avant une écriture. La dernière{"\u00a0"}: { $last }.
    }

## The dialog that makes a program without a timer.

newProgram_title = Nouveau programme…
newProgram_timerClass = Classe
newProgram_functions = Fonctions, sans le départ et DT
newProgram_servos = Servos
newProgram_from = Commencer avec
newProgram_beginnings_usual = Temps habituels, servos au milieu
newProgram_beginnings_nothing = Tous les temps et positions à 0
newProgram_caution = Les positions de votre modèle ne sont pas connues ici. Réglez chacune d’elles avant d’écrire.
newProgram_make = Créer le programme

## The picture of a program over time.

timeline_title = Chronologie
timeline_compareBefore = avant le suivi
timeline_picture = Positions des servos au fil du temps
timeline_description = { $servos } et { $functions } au fil du temps, DT à { $dt }. Le tableau contient toutes les valeurs.
timeline_descriptionMotor = { $servos } et { $functions } au fil du temps, DT à { $dt }, arrêt moteur à { $motorStop }. Le tableau contient toutes les valeurs.
timeline_functions =
    { $count ->
        [one] { $count } fonction
       *[other] { $count } fonctions
    }
timeline_servos =
    { $count ->
        [one] { $count } servo
       *[other] { $count } servos
    }
timeline_keysToEdit = Les flèches vont de repère en repère et de servo en servo, plus et moins changent le zoom, 0 montre tout. Entrée mène aux poignées{"\u00a0"}: les flèches les déplacent, Échap en revient.
timeline_ask = Pointez ou touchez pour lire
timeline_finer = Plus fin
timeline_steps =
    { $position ->
        [one] { $position } pas
       *[other] { $position } pas
    }
timeline_stepsUnit = pas
timeline_notKnown = Pas connu{"\u00a0"}: les temps diminuent
timeline_tools = Vue
timeline_zoomIn = Zoom avant
timeline_zoomOut = Zoom arrière
timeline_fit = Tout afficher
timeline_passedOver = { $slot }{"\u00a0"}: étape sautée, { $next } vient au même moment.
timeline_goesBack = { $next } vient avant { $slot }. On ne sait pas ce que fait la minuterie dans la partie ombrée.

## A new version of the page.

update_ready = Une nouvelle version est prête.
update_waits = Elle démarre quand la minuterie est déconnectée et que rien n’est ouvert ou non enregistré.
update_take = L’utiliser maintenant
update_news = Nouveautés

## The version of this page.

aboutPage_title = Cette page
aboutPage_version = Sidus Timer { $version }.
aboutPage_offline = Toute la page est sur cet appareil{"\u00a0"}: elle marche sans réseau.
aboutPage_notOffline = La page n’est pas encore conservée sur cet appareil{"\u00a0"}: ouvrez-la une fois avec du réseau.
aboutPage_licences = Licences

## The views of the page and the links between them.

views_title = Vues
views_names_program = Programme
views_names_memories = Mémoires
views_names_bench = Banc
views_names_library = Bibliothèque
views_names_line = Liaison
views_names_settings = Paramètres
views_names_print = Impression
views_names_help = Aide
views_print = Imprimer…
views_share = Partager…
views_noTimer_memories = Connectez une minuterie pour voir ses mémoires. Les sauvegardes sont plus bas.
views_noTimer_bench = Connectez une minuterie pour déplacer ses servos.

## The strip above every view: the timer, its memory, DT, motor stop, and what is known.

strip_panel = Mémoires et plus
strip_tried =
    { $count ->
        [one] { $count } essayée
       *[other] { $count } essayées
    }
strip_notCertain = incertain
strip_asRead = dern. lecture
strip_notValid = non valide
strip_ofSetting =
    { $changes ->
        [0] enregistré
       *[other] { $changes } à enregistrer
    }
strip_made = hors minuterie

## The list of commands.

palette_title = Commandes
palette_search = Tapez ce que vous voulez faire
palette_nothing = Aucune commande n’a ce nom, ou elle n’est pas possible maintenant.
palette_ctrl = Ctrl+{ $key }

## In place of a part of the page that is being loaded.

parts_coming = Chargement
parts_failed = Une partie de cette page n’a pas pu être chargée.
parts_again = Réessayer

## Which model it is.

whichModel_recognition_same = C’est { $model }, tel que vu ({ $when }).
whichModel_recognition_like =
    { $count ->
        [one] Cela ressemble à { $model }, { $count } valeur diffère. Est-ce { $model }{"\u00a0"}?
       *[other] Cela ressemble à { $model }, { $count } valeurs diffèrent. Est-ce { $model }{"\u00a0"}?
    }
whichModel_recognition_several = C’est peut-être { $models }. Quel modèle est-ce{"\u00a0"}?
whichModel_or = { $names } ou { $last }
whichModel_others =
    { $count ->
        [one] { $count } autre
       *[other] { $count } autres
    }
whichModel_recognition_unknown = Cette minuterie n’est pas connue ici. Quel modèle est-ce{"\u00a0"}?
whichModel_recognition_yes = Oui, { $model }
whichModel_recognition_choose = Choisir…
whichModel_recognition_ok = OK
whichModel_recognition_dialog_title = Quel modèle est-ce{"\u00a0"}?
whichModel_recognition_dialog_lead = Une minuterie ne connaît pas son modèle. La page compare ce qu’elle contient avec ce qu’elle a vu en dernier dans chaque modèle.
whichModel_recognition_dialog_said = Vous avez dit que c’est { $model }.
whichModel_recognition_dialog_moreMemories = Lisez aussi les autres mémoires{"\u00a0"}: elles permettront peut-être de distinguer les modèles.
whichModel_recognition_dialog_none = Aucun modèle correspondant dans cette classe.
whichModel_recognition_dialog_newModel = Un nouveau modèle
whichModel_recognition_dialog_keep = Conserver comme nouveau modèle
whichModel_memoryNames_label = Nom de { $memory }
whichModel_memoryNames_give = Nommer
whichModel_crossing_title = Ce sont des valeurs du modèle { $from }, mais cette minuterie ressemble à celle du modèle { $to }.
whichModel_crossing_advice = Avec les valeurs d’un autre modèle, vous pouvez perdre celui-ci. Regardez le modèle devant vous.
whichModel_crossing_confirm = Écrire des valeurs du modèle { $from } dans la minuterie du modèle { $to }.
whichModel_crossing_memoryOf = { $memory } ({ $model })

## A write, from the difference to the verdict.

write_title = Écrire dans la minuterie
write_lead = Voici ce qui change dans { $memory }. Le reste ne change pas.
write_target = Écrire dans
write_nothing = Rien ne diffère. La minuterie est relue et comparée.
write_field = Valeur
write_from = Contient
write_to = Contiendra
write_wasRead = Lu avant
write_moved_model_title = Cette minuterie semble maintenant appartenir à un autre modèle.
write_moved_model_advice = Rien n’a été écrit. Regardez les noms des modèles.
write_moved_edits_title = Le programme a changé depuis que ceci a été affiché.
write_unkept_title = Cet appareil n’a pas pu conserver une sauvegarde de ce que contient la minuterie maintenant.
write_unkept_advice = Cette mémoire est encore comme avant. Continuer sans sauvegarde{"\u00a0"}?
write_sideBySide = Valeurs{"\u00a0"}: { $names }
write_withoutCopy = Continuer sans sauvegarde
write_safety = L’hélice est démontée ou le modèle est tenu, et la minuterie n’est pas armée.
write_acknowledge = J’ai lu ceci et je veux écrire quand même.
write_stillToTick = Encore à cocher{"\u00a0"}: { $ticks }.
write_ticks_model = autre modèle
write_ticks_warnings = avertissements
write_ticks_safety = hélice
write_move_why = Cette minuterie semble ne garder les positions qu’à la fonction où sont ses servos. Si les servos ne bougent pas, elle ne gardera probablement pas celles-ci.
write_move_label = Amener les servos à chaque fonction avant que ses positions soient écrites.
write_move_hint = Tenez bien le modèle, et que rien ne gêne les servos.
write_move_notHeld_title = La minuterie a confirmé les positions mais ne les a pas gardées.
write_move_notHeld_advice = Cette minuterie ne les garde probablement qu’à la fonction où sont ses servos. Écrivez à nouveau, et laissez les servos aller à chaque fonction.
write_move_again = Écrire à nouveau…
write_start =
    { $count ->
        [0] Relire et comparer
        [one] Écrire { $count } changement
       *[other] Écrire { $count } changements
    }
write_stages_read = Lecture
write_stages_write = Écriture
write_stages_verify = Relecture
write_stages_repair = Correction
write_stopping = Arrêt après cette demande
write_stoppingBack = Arrêt{"\u00a0"}: retour d’abord à la mémoire d’avant
write_verified_title = Vérifié.
write_verified_advice = La minuterie a été relue et contient ce qui était affiché.
write_verdict = { $memory } vérifiée ({ $time })
write_asItIs = tel quel
write_insteadOf = au lieu de { $value }
write_wanted = À écrire
write_readBack = Relu
write_differs_title = La minuterie n’a pas pris toutes les valeurs.
write_differs_advice = La minuterie a été relue. Elle contient ici d’autres valeurs{"\u00a0"}:
write_unknown_title = On ne sait pas avec certitude ce que contient la minuterie.
write_unknown_advice = La minuterie n’a pas pu être relue complètement. Relisez, puis écrivez ce qui diffère encore. Vos changements sont conservés.
write_cut = L’écriture dans { $memory } a été interrompue.
write_strayed_title = { $memory } est devenue la mémoire sélectionnée pendant l’écriture.
write_strayed_advice = Certaines des valeurs sont peut-être maintenant dans { $memory }. Lisez-la, et regardez-la en entier avant de voler avec elle.
write_refused = Rien n’a été écrit.
write_status_differs = diffère
write_status_unknown = inconnu
write_putBack = changé par la minuterie elle-même, rétabli

## What the parts of the page that are loaded first say.

name = Sidus Timer
classNames_Q = F1Q
classNames_B = F1B
classNames_E = F1E
unknownClass = Classe { $letter }
memoryName = M{ $number }
servoName = S{ $number }
slotName =
    { $kind ->
        [start] Départ
        [dt] DT
       *[function] Fonction { $slot }
    }
within_slot =
    { $kind ->
        [start] départ
        [dt] DT
       *[function] fonction { $slot }
    }
within_idleThrottle = ralenti
slotShort =
    { $kind ->
        [start] Départ
        [dt] DT
       *[function] { $slot }
    }
about = { $name }{"\u00a0"}:
previous = Précédent
next = Suivant
pause = Pause
less = { $what }{"\u00a0"}: moins
moreOf = { $what }{"\u00a0"}: plus
seconds = { $time }{" "}s
times_minutes = { $minutes }{" "}min
times_minutesSeconds = { $minutes }{" "}min { $seconds }{" "}s
times_units_s = s
times_units_min = min
times_figure = { $text } { $unit }
times_asSeconds = { $seconds }{" "}s, { $clock }
times_meaning = { $field }{"\u00a0"}: ce que signifie ce texte
header_firmware = firmware { $firmware }
header_simulated = simulée
header_connect = Connecter
header_choosePort = Choisir un autre adaptateur
header_closeProgram = Fermer le programme
header_disconnect = Déconnecter
header_stop = Arrêter
program_tableCaption = Temps et positions des servos de chaque fonction
program_slot = Fonction
program_time = Temps
program_memory = Mémoire
program_memoryUnknown = Cette minuterie ne dit pas quelle mémoire est sélectionnée, on ne sait donc pas laquelle servira au prochain vol.
program_memoryOpen = On ne sait pas quelle mémoire servira au prochain vol. Choisissez-en une pour le prochain vol, ou relisez.
program_dt = DT
program_motorStop = Arrêt moteur
program_motor = Moteur
program_idleThrottle = Ralenti
program_throttle = Ralenti
program_idleThrottleUnit = unité inconnue
program_reserved = réservé { $time }
program_timeOf = { $slot }, temps
program_motorStopTime = Arrêt moteur, temps
program_positionOf = { $slot }, { $servo }
program_shortDt = DT court
program_changes =
    { $count ->
        [one] { $count } changement
       *[other] { $count } changements
    }
program_undoAll = Tout annuler
program_read = Relire
program_connectAndWrite = Connecter et écrire…
program_write =
    { $count ->
        [0] Écrire…
        [one] Écrire { $count } changement…
       *[other] Écrire { $count } changements…
    }
program_picture = Image
program_table = Tableau
program_blocked = Rien ne peut encore être écrit. { $field }{"\u00a0"}: { $why }
program_findings = Contrôles
program_noFindings = Rien d’inhabituel.
program_absolute = Affiché à partir du départ. On ne sait pas si cette minuterie compte à partir du départ ou de la fonction précédente.
program_severity_error = Impossible à écrire
program_severity_serious = Grave
program_severity_warning = Inhabituel
program_reading = Lecture de la minuterie
program_selecting = Changement de mémoire
otherTab_holdsSince = Sidus Timer est ouvert dans un autre onglet, depuis { $since }.
otherTab_holds = Sidus Timer est ouvert dans un autre onglet.
otherTab_takeOver = L’utiliser ici
otherTab_busy = L’autre onglet travaille avec la minuterie. La page s’ouvre ici dès que c’est terminé.
otherTab_gone = L’autre onglet ne répond pas. Fermez-le, puis rechargez cette page.
disturbed = Des réponses manquent ou sont endommagées{"\u00a0"}: la minuterie est-elle réveillée, la tête infrarouge proche et à l’abri du soleil{"\u00a0"}? Ceci se termine dans { $seconds } s au plus tard.
cancel = Annuler
close = Fermer
copy = Copier
copied = Copié.
copyByHand = Le navigateur ne laisse pas cette page copier. Copiez d’ici.
dismiss = Masquer
done = Terminé
undo = Annuler
open = Ouvrir
save = Enregistrer
delete = Supprimer
notNow = Plus tard
label_language = Langue
label_name = Nom
label_note = Note
label_model = Modèle
label_search = Rechercher
noModel = Aucun modèle
more = Et { $count } de plus.
showMore = Afficher { $count } de plus
of = { $button }{"\u00a0"}: { $name }
notFitting = Il ne convient pas à la minuterie connectée. Déconnectez-la pour l’ouvrir.
notKept = Ce navigateur ne l’a pas conservé{"\u00a0"}: il est perdu quand cette page est fermée.

## The walk through the open questions of docs/protocol.md with a real timer.

settle_title = Lever les doutes avec votre minuterie
settle_lead = On ne sait pas tout de la façon dont ces minuteries communiquent. En un quart d’heure, la vôtre répond aux questions ouvertes. Chaque valeur essayée est rétablie. Ayez le programmateur sous la main.
settle_safe = L’hélice est démontée ou le moteur est débranché, et la minuterie n’est pas armée.
settle_danger = Quelque chose peut bouger maintenant. L’hélice est-elle démontée, ou le moteur débranché{"\u00a0"}? Regardez encore une fois.
settle_blocked = Traitez d’abord le message du bandeau coloré en haut de la page, et conservez ce qui a été essayé ou rétablissez les valeurs d’avant.
settle_readIt = Lire la minuterie
settle_which = Que montre le programmateur{"\u00a0"}?
settle_tryHint = Déplacez les servos avec les boutons de la page et attendez qu’ils soient immobiles. Essayez ensuite une position{"\u00a0"}: elle est changée puis rétablie en quelques secondes. Observez les servos.
settle_tryIt = Essayer une position
settle_moved = L’ancienne position est revenue{"\u00a0"}: la page l’a relue. Un servo a-t-il bougé pendant l’essai de la nouvelle{"\u00a0"}?
settle_ask = Demander avec quatre zéros
settle_unknown = Je ne sais pas
settle_send = Envoyez le fichier avec ce formulaire
settle_names_order = L’octet de poids faible d’un temps vient en premier
settle_names_unit = Les temps sont en centièmes de seconde
settle_names_count = Les temps comptent à partir du départ
settle_names_memories = La première mémoire a le numéro 0
settle_names_zeros = Quatre zéros suffisent
settle_names_layout = La fonction vient avant le servo
settle_names_stores = Les positions sont gardées à n’importe quelle fonction
settle_names_moves = Une position écrite fait bouger son servo
settle_names_unlock = Lettre qui répond à UNLOCK
settle_names_delay = Temps de réponse habituel
settle_names_reserved = Temps réservé tel que lu
settle_yes = Oui
settle_no = Non
settle_unnumbered = Aucun numéro n’est donné
settle_there = Seulement à la fonction où sont les servos
settle_delay = { $ms } ms
settle_open = Non établi
