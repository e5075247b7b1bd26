### Tutto ciò che la pagina dice, in italiano: una traduzione di en.ftl, con gli stessi nomi. Translated without a pilot
### of that language; corrections welcome (docs/translating.md).

## Moving servos and motor from the page.

bench_slots = Vai a
bench_elsewhere = Servi e motore lavorano con { $memory }, la memoria del prossimo volo. Mostrare { $memory } per muoverli.
bench_trim = Regolazione: { $slot }
bench_at = Posizione dei servi: { $slot }
bench_atNone = Non è noto dove si trovano i servi.
bench_moveMaybe = Nessuna risposta. I servi potrebbero essersi mossi comunque. Guardare il modello.
bench_unlocked = Il motore è sbloccato. L’elica può partire.
bench_unlockMaybe = Nessuna risposta. Il motore potrebbe essere comunque sbloccato. Stare lontani dall’elica.
bench_jumped = Il timer ha confermato il salto.
bench_here = servi qui
bench_waits = Attende «Scrivi».
bench_bring = Porta i servi a { $slot }
bench_follow = I servi seguono le posizioni
bench_followHint = Prima la pagina legge il timer e conserva un backup. Poi ogni posizione cambiata nella riga in cui si trovano i servi viene memorizzata subito nel timer, e il suo servo si muove.
bench_followingNow = I servi seguono: una posizione cambiata nella riga in cui si trovano viene memorizzata subito nel timer.
bench_stopFollowing = Smetti di seguire
bench_ended_over = I servi non seguono più le posizioni.
bench_ended_memory = I servi non seguono più: è corrente un’altra memoria, o potrebbe esserlo.
bench_ended_strayed = Mentre i servi seguivano è diventata corrente un’altra memoria. Potrebbe aver preso alcune delle posizioni: controllarla tutta prima di volare con essa.
bench_ended_unlike = I servi non seguono più: il timer non ha fatto ciò che ha confermato.
bench_ended_failed = I servi non seguono più: il timer non ha risposto.
bench_notTaken = { $field } contiene { $held }, non { $wanted }.
bench_beside =
    { $more ->
        [0] Cambiati inoltre: { $named }.
        [one] Cambiati inoltre: { $named }; e { $more } altro valore.
       *[other] Cambiati inoltre: { $named }; e altri { $more } valori.
    }
bench_triedHere =
    { $more ->
        [0] Provate: { $named }.
        [one] Provate: { $named }; e { $more } altra posizione.
       *[other] Provate: { $named }; e altre { $more } posizioni.
    }
bench_triedAndWaiting =
    { $waiting ->
        [0] Provate nel timer: { $tried }
        [one] Provate nel timer: { $tried }; { $waiting } attende «Scrivi»
       *[other] Provate nel timer: { $tried }; { $waiting } attendono «Scrivi»
    }
bench_triedIn = Sono state provate posizioni in { $memory }.
bench_decide = Tenere ciò che è stato provato, o rimettere ciò che il timer conteneva prima?
bench_keep = Tieni così
bench_putBack = Rimetti com’era…
bench_unlock = Tieni premuto: UNLOCK
bench_unlockHold = Tieni premuto
bench_unlockHint = L’elica può partire. Tenere saldo il modello e le mani lontane dall’elica, poi premere e tenere premuto.
bench_experimental = Sperimentale
bench_jumpHint = Salta alla funzione che segue un DT anticipato. L’effetto esatto non è documentato: i servi possono muoversi.
bench_jump = Salta…
bench_jumpSure = Invia ora il salto

## The log of flights.

flights_title = Voli
flights_empty_title = Nessun volo registrato.
flights_empty_advice = Leggere o scrivere un timer, poi premere «{ flights_flying_button }».
flights_failed = Il browser ora non può leggere la libreria. Chiudere le altre schede di questa pagina e riprovare.
flights_flying_button = Volo così
flights_flying_purpose = Registra un volo con ciò che il timer contiene.
flights_flying_logged = Volo registrato { $time }
flights_flying_fillIn = Completa
flights_flying_again = Ancora un volo così
flights_row_round = Lancio { $round }
flights_row_wind = { $wind } m/s
flights_row_temperature = { $degrees } °C
flights_row_noResult = senza risultato
flights_row_changed = { $values } cambiati
flights_row_otherTimer = altro timer
flights_totals_flights =
    { $count ->
        [one] { $count } volo
       *[other] { $count } voli
    }
flights_totals_best = migliore { $time }
flights_totals_average = media { $time }
flights_filter_of = Voli di { $name }
flights_filter_clear = Mostra tutti
flights_form_title = Volo
flights_form_result = Risultato
flights_form_resultHint = Secondi, o minuti come 2:58.
flights_form_readAs = { $time }, { $seconds } s
flights_form_propose = Annota { $facts }
flights_form_full = Pieno, 180 s
flights_form_round = Lancio
flights_form_flyOff = Spareggio
flights_form_wind = Vento
flights_form_windUnit = m/s
flights_form_temperature = Temperatura
flights_form_temperatureUnit = °C
flights_form_when = Data, luogo, modello
flights_form_date = Data e ora
flights_form_noOffset = Il fuso orario del campo non è noto: questa è l’ora di questo dispositivo.
flights_form_place = Luogo
flights_form_flown = Programma usato
flights_form_open = Apri il suo programma
flights_form_unreadable_not-a-number = Non è un numero.
flights_form_unreadable_not-a-time = Non è un tempo: inserire secondi come 178, o minuti come 2:58.
flights_form_unreadable_too-fine = { unreadable_too-fine }
flights_form_range = Da { $min } a { $max } { $unit }.
flights_form_shortDt = In questo volo il DT era { $dt }.
flights_score_open = Cartellino
flights_score_maximum = Massimo di ogni lancio
flights_score_none = Senza un massimo ogni risultato conta per intero.
flights_score_maximumOf = Massimo: { $round }
flights_score_counted = Conta (s)
flights_score_notCounted = non conta
flights_score_count = Conta questo
flights_score_noRound = senza lancio
flights_score_total = Totale
flights_score_copy = Copia come testo
flights_csv_save = Salva come tabella (CSV)
flights_csv_columns_date = Data
flights_csv_columns_time = Ora
flights_csv_columns_zone = Fuso orario
flights_csv_columns_place = Luogo
flights_csv_columns_model = Modello
flights_csv_columns_setting = Programma
flights_csv_columns_timerClass = Classe del timer
flights_csv_columns_memory = Memoria
flights_csv_columns_dt = DT (s)
flights_csv_columns_motorStop = Stop motore (s)
flights_csv_columns_wind = Vento (m/s)
flights_csv_columns_temperature = Temperatura (°C)
flights_csv_columns_round = Lancio
flights_csv_columns_result = Risultato (s)
flights_csv_columns_maximum = Massimo (s)
flights_csv_columns_note = Nota
flights_section_all = Tutti i suoi voli

## Values that are unusual, or cannot be written.

findings_time-not-whole = { unreadable_not-a-whole-number }
findings_time-out-of-range = Deve essere da { $min } a { $max }.
findings_position-not-whole = { unreadable_not-a-whole-number }
findings_position-out-of-range = Deve essere da { $min } a { $max }.
findings_throttle-not-whole = { unreadable_not-a-whole-number }
findings_throttle-out-of-range = Deve essere da { $min } a { $max }.
findings_position-as-read = Letto come { $value }, oltre l’ultimo passo, { $max }. Resta così se non viene cambiato.
findings_time-falls = Nel tempo viene prima della funzione sopra ({ $previous }).
findings_time-repeats = Lo stesso tempo della funzione sopra, { $previous }.
findings_position-never-reached = Lo stesso tempo della funzione sopra, { $previous }. Le posizioni della funzione sopra non vengono mai raggiunte.
findings_motor-stop-after-dt = Il motore si ferma dopo il DT ({ $dt }): il modello scende con il motore in moto.
findings_motor-run-long = Il motore gira più a lungo di { $limit }, il limite per F1Q.
findings_time-outside-manual = Il manuale ammette da { $min } a { $max }.
findings_time-too-fine = Il manuale indica incrementi di { $step }: il timer può arrotondare.
findings_dt-short = Più breve di { $limit }.
findings_dt-moves-nothing = Al DT non si muove nessun servo: il timer non fa scendere il modello.
findings_throttle-unusual = Più di { $limit } è insolito. L’unità non è nota.
findings_class-unknown = La classe «{ $timerClass }» non è nota: le sue regole non sono state controllate.

## Why a text in a field is no value.

unreadable_empty = Vuoto: inserire un valore.
unreadable_not-a-time = Non è un tempo: inserire secondi come 12,5, o minuti come 2:05.
unreadable_too-fine = Più preciso di un centesimo di secondo.
unreadable_not-a-whole-number = Deve essere un numero intero.
unreadable_ambiguous = Si può leggere in più modi: sceglierne uno.

## For a page that cannot reach a timer here.

restWorks = Qui funziona anche tutto il resto, tranne la connessione.

## What an Android phone needs.

firstVersions_android = 148
firstVersions_androidBluetooth = 138
firstVersions_lastBluetoothOnly = 147
firstVersions_androidCable = 17
android = Chrome { firstVersions_android } o successivo (da { firstVersions_androidBluetooth } a { firstVersions_lastBluetoothOnly } solo via Bluetooth); per un cavo serve Android { firstVersions_androidCable }

## For every browser about which nothing more is known. docs/connection.md names the first versions.

unsupportedHere_title = Questo browser non può raggiungere un timer.
unsupportedHere_advice = Su un computer usare una versione attuale di Chrome, Edge, Opera o Firefox; su un telefono, Chrome per Android. { restWorks }

## Replaces the sentence above where the browser's name tells more.

unsupported_brave_title = Brave raggiunge un timer solo con il permesso dell’utente.
unsupported_brave_advice = Aprire brave://flags/#brave-web-serial-api, scegliere Enabled e premere Relaunch. { restWorks }
unsupported_ios_title = Nessun browser su iPhone o iPad può raggiungere un timer.
unsupported_ios_advice = Usare un computer, o Chrome su un telefono Android. { restWorks }
unsupported_android_title = { unsupportedHere_title }
unsupported_android_advice = Su Android usare { android }. { restWorks }

## What a saved program held before it was saved over.

versions_title = Versioni precedenti
versions_until = Fino a:{"\u00a0"}{ $when }
versions_changed =
    { $more ->
        [0] poi { $change }
        [one] poi { $change } e{"\u00a0"}{ $more }{"\u00a0"}altro
       *[other] poi { $change } e{"\u00a0"}{ $more }{"\u00a0"}altri
    }
versions_otherLayout = poi valori per un altro timer
versions_same = Il programma salvato ora contiene questo.
versions_goBack = Torna a questa

## Two programs side by side.

compare_title = Confronto
compare_open = Confronta…
compare_second = con
compare_screen = Sullo schermo
compare_timer = Timer, { $memory }
compare_groups_now = Ora
compare_groups_settings = Programmi salvati
compare_setting = { $model } · { $name }
compare_backup = { $memory } · { $when }
compare_backupOf = { $model } · { $memory } · { $when }
compare_nothing = Questo dispositivo non ha altri programmi di questa classe e struttura.
compare_take = Prendi
compare_takeOf = Prendi { $value } per { $field }
compare_takeHint = «Prendi» copia un valore nel programma sullo schermo.

## How a backup differs from what its timer holds.

modelBackups_same = come nel timer { $when }
modelBackups_differs =
    { $count ->
        [one] { $count } valore diverso dal timer { $when }
       *[other] { $count } valori diversi dal timer { $when }
    }
modelBackups_now = ora


## Undo, redo, and edits of many fields at once.

edits_redoButton = Ripeti
edits_undo = Annulla { $step }
edits_redo = Ripeti { $step }
edits_steps_change = modifica di { $what }
edits_steps_shift = spostamento da { $what } di { $by }
edits_steps_step-servo = { $what } di { $steps }
edits_steps_step-servo-from = { $what } di { $steps }, da { $from }
edits_steps_paste = incolla: { $count }
edits_steps_fill = riempimento: { $count }
edits_steps_revert-all = ritorno di tutti i valori
edits_steps_open = apertura di { $what }
edits_steps_keep-tried = conferma di ciò che è stato provato
edits_opened = «{ $name }»
edits_openedUnnamed = un altro programma
edits_refused_start = Il lancio non ha un tempo da cambiare.
edits_refused_later-out-of-range = Una funzione successiva non sarebbe più tra { $min } e { $max }.
edits_refused_unreadable = C’è di mezzo un testo che non è un valore. Prima va corretto.
edits_refused_interval-disagrees = Questo intervallo non corrisponde ai tempi delle due righe.
edits_refused_no-place = Il programma non ha questo posto.
edits_refused_twice = Questo posto compare due volte, con valori diversi.
edits_refused_too-large = La tabella è troppo grande: si leggono al massimo { $cells } celle. Il resto è stato tralasciato.
edits_beforeLaunch = Sarebbe prima del lancio.
edits_nothingDone = Nulla è stato cambiato.
edits_cells =
    { $count ->
        [one] { $count } valore
       *[other] { $count } valori
    }
edits_change = { $field }: { $from } → { $to }
edits_field_putBack = Rimetti { $field }
edits_field_putBackTo = Rimetti { $field } a { $figure }
edits_sheet_title = Tasti per { $field }
edits_sheet_erase = Cancella l’ultima cifra
edits_sheet_putBack = Rimetti
edits_sheet_selectRange = Seleziona celle
edits_sheet_goTo = Vai a { $name }
edits_table_explain = Che cosa sono i valori
edits_table_interval = Dopo
edits_table_countedFrom = da { $row }
edits_table_switch = Tempo o Dopo
edits_table_intervalOf = Intervallo, { $slot }
edits_table_range_title = Celle selezionate
edits_table_range_pick = Ora toccare un’altra cella.
edits_table_range_size = { $cells }, { $columns }
edits_table_range_functions =
    { $count ->
        [one] { $count } funzione
       *[other] { $count } funzioni
    }
edits_table_range_rows =
    { $count ->
        [one] { $count } riga
       *[other] { $count } righe
    }
edits_table_range_columns =
    { $count ->
        [one] { $count } colonna
       *[other] { $count } colonne
    }
edits_table_range_paste = Incolla…
edits_table_range_fillDown = Riempi in basso
edits_table_range_clipboardClosed = Non c’è nulla da incollare che questa pagina possa vedere. Toccare il primo campo e incollare lì.
edits_table_tools = Strumenti per { $name }
edits_stepServo_title = Tutte le posizioni di { $servo }
edits_stepServo_now = Ora { $position }
edits_stepServo_nowRange = Ora da { $lowest } a { $highest }
edits_stepServo_by = Di, in passi
edits_stepServo_step = Sposta
edits_stepServo_which = Quali
edits_stepServo_all = Tutte le funzioni
edits_stepServo_from = Da { $slot } in poi
edits_stepServo_stops =
    { $count ->
        [one] { $steps }: { $what } si ferma a { $at }.
       *[other] { $steps }: { $what } si fermano a { $at }.
    }
edits_shift_open = Sposta…
edits_shift_from =
    { $isLast ->
        [true] { $row }
       *[false] { $row } e seguenti
    }
edits_shift_by = Di, in secondi
edits_shift_earlier = Anticipa
edits_shift_later = Ritarda
edits_shift_moveDt = Sposta anche il DT
edits_shift_function = funzione { $number }
edits_shift_functionRange = funzioni da { $first } a { $last }
edits_shift_functions = funzioni { $numbers }
edits_shift_moved =
    { $later ->
        [true] Ritardato di { $time }{" "}s
       *[false] Anticipato di { $time }{" "}s
    }
edits_pasting_asks = Questi nomi non sono noti. Indicare che cosa significano:
edits_pasting_choose = Scegli
edits_pasting_leaveOut = Tralascia
edits_pasting_table = Che cosa va dove
edits_pasting_lead =
    { $count ->
        [0] Questo non cambia nulla.
        [one] Questo cambia { $count } valore.
       *[other] Questo cambia { $count } valori.
    }
edits_pasting_reading = { $field }: «{ $text }» viene letto come { $time }.
edits_pasting_problems = Non si può incollare:
edits_pasting_place = Riga { $row }, colonna { $column } del testo copiato
edits_pasting_problem = { $place }: { $reason }
edits_pasting_problemOf = { $place }, «{ $text }»: { $reason }
edits_pasting_apply = Incolla
edits_presets_title = DT predefiniti
edits_presets_use = DT { $time }
edits_presets_refused = Inserire tempi come 20 s o 2:30, fino a 10:55 min, al massimo 24.
edits_fix = Imposta { $value }
edits_fixOf = Imposta { $value }: { $field }

## The library as files: export, import, and the reminder to export.

files_export_all = Esporta tutto…
files_export_one = Esporta…
files_export_downloaded = «{ $name }» va tra i download: { $what }. Controllare che ci sia.
files_export_without = senza { $kind }
files_export_kinds_models = modelli
files_export_kinds_settings = programmi
files_export_kinds_flights = voli
files_export_partly = «{ $name }» non è completo. Contiene { $what }. Il browser ora non può leggere: { $missing }. Chiudere le altre schede di questa pagina ed esportare di nuovo.
files_export_and = { $first } e { $next }
files_export_tooLarge = La libreria è troppo grande per un solo file. Esportare i modelli uno per uno.
files_export_failed = Non è stato possibile creare il file. Ricaricare la pagina e riprovare.
files_import_button = Importa…
files_import_title = Importa { $name }
files_import_lead = Salvato { $date }. Contiene { $what }.
files_import_leadNothing = Salvato { $date }. Non contiene nulla.
files_import_ignored =
    { $count ->
        [one] { $count } voce è di una versione più nuova di questa pagina e viene tralasciata.
       *[other] { $count } voci sono di una versione più nuova di questa pagina e vengono tralasciate.
    }
files_import_nothing = Tutto questo c’è già.
files_import_differs = Differenze
files_import_ways_newer = Prendi il più nuovo
files_import_ways_both = Tieni entrambi
files_import_itself = il modello stesso
files_import_flightOf = volo: { $day }
files_import_wayText_newer = Resta ciò che qui è più nuovo o ha la stessa data.
files_import_wayText_both = Restano entrambi. Quello del file riceve un numero dopo il nome.
files_import_unknownModel = Un modello che qui non c’è
files_import_group_fresh = Nuovi: { $what }
files_import_group_same = Uguali: { $what }
files_import_group_fileNewer = Più nuovi nel file: { $what }
files_import_group_deviceNewer = Non più nuovi nel file: { $what }
files_import_group_fileName = { $file } (qui: { $here })
files_import_take =
    { $count ->
        [0] Nulla da importare
       *[other] Importa { $count }
    }
files_import_allStays = Nel file non c’è nulla di più nuovo. Scegliere «{ files_import_ways_both }» per importarlo comunque.
files_import_done = Importati da «{ $name }»: { $what }.
files_import_undo = Annulla l’importazione
files_import_undone = L’importazione è stata annullata. Le modifiche successive restano.
files_refused_title = { $name } non può essere importato
files_refused_nothing = Nulla è stato importato.
files_refused_again = Esportare di nuovo il file, o chiederne uno nuovo a chi lo ha inviato.
files_refused_fault = Riga{"\u00a0"}{ $line }: trovato { $found }.
files_refused_faultIn = Riga{"\u00a0"}{ $line }, { $place }: trovato { $found }.
files_refused_wanted = Previsto:
files_refused_place_entry =
    { $kind ->
        [models] Modello «{ $name }»
        [settings] Programma «{ $name }»
       *[flights] Volo «{ $name }»
    }
files_refused_place_unnamed =
    { $kind ->
        [models] Modello { $number } nel file
        [settings] Programma { $number } nel file
       *[flights] Volo { $number } nel file
    }
files_refused_place_function = funzione { $number }
files_refused_damaged = Il file è danneggiato o incompleto.
files_refused_files_too-large = Il file è troppo grande per una libreria.
files_refused_files_gone = Non è stato possibile leggere il file. Sceglierlo di nuovo.
files_refused_files_several = Importare un file alla volta.
files_refused_format = Non è un file della libreria di Sidus Timer.
files_refused_newer = È stato creato da una versione più nuova di questa pagina. Ricaricare la pagina con la rete disponibile.
files_reminder =
    { $changes ->
        [one] { $changes } modifica della libreria è solo su questo dispositivo. Se il dispositivo va perso, solo un file la riporta.
       *[other] { $changes } modifiche della libreria sono solo su questo dispositivo. Se il dispositivo va perso, solo un file le riporta.
    }

## For the time before the other sentences are loaded.

first_failed = La pagina non è completa. C’è rete?
first_again = Ricarica

## What a system shows of the installed page: public/manifest.webmanifest has the same in English.

manifest_description = Imposta i timer Sidus F1Q, F1B e F1E per il volo libero: legge ciò che un timer contiene, prende le modifiche, le scrive, le rilegge e confronta. Conserva modelli e programmi su questo dispositivo. Funziona senza rete.
manifest_connect = Connetti un timer
manifest_connectShort = Connetti
manifest_connectWhat = La pagina iniziale, con Connetti a portata di mano
manifest_library = Libreria
manifest_libraryWhat = I modelli e i loro programmi
manifest_simulated = Timer simulato
manifest_simulatedWhat = La pagina iniziale, con i timer simulati a portata di mano
manifest_pictures_program = Il programma di un timer, con due modifiche segnate
manifest_pictures_write = Che cosa cambierà una scrittura, prima di scrivere
manifest_pictures_programPhone = L’intero programma su un telefono
manifest_pictures_writePhone = Che cosa cambierà una scrittura, su un telefono

## The help inside the page.

guide_pages_checklist = Checklist
guide_pages_trouble = Problemi
guide_pages_words = Valori
guide_pages_steps = Primi passi
guide_nav = Pagine di aiuto

## What a new pilot is told.

firstSteps_1 = Leggere: premere Connetti, svegliare il timer, avvicinare la testina a infrarossi. La lettura non cambia nulla e non muove nulla.
firstSteps_2 = Scrivere: inserire i nuovi valori, premere Scrivi, guardare ogni differenza. «Verificato» significa: il timer è stato letto di nuovo e contiene ciò che si voleva.
firstSteps_3 = Volare: in cima alla pagina si vede con quale memoria sarà il prossimo volo, e il suo DT. La pagina non ha bisogno di rete, e nulla lascia questo dispositivo.

## The values of a program, with unit and range.

values_function_text = Una tappa del volo: al suo tempo ogni servo va alla sua posizione. Per saltarla, darle le posizioni della funzione precedente.
values_function_range = Di solito lancio, nove funzioni e DT.
values_time_text = Quando comincia una funzione, contando dal lancio. Inserire 12,5 o 2:05. Per F1B e F1E non è noto da dove il timer conta.
values_time_range = Secondo i manuali. F1Q: da 0,1 a 99,9 s. F1B: da 0,01 a 9,99 s per le funzioni 1 e 2, poi da 0,1 a 99,9 s. F1E: non noto.
values_after_text = Il tempo trascorso dalla funzione precedente. Tutte le funzioni successive si spostano con esso, il DT no.
values_position_name = Posizione
values_position_text = Dove si trova un servo. L’angolo di un passo dipende dal servo e dai rinvii: provarlo al banco.
values_position_range = Da 0 a 130 passi.
values_motorStop_text = F1Q: quando il motore si ferma, contando dal lancio. Nessun servo si muove con esso.
values_motorStop_range = Secondo il manuale da 0,1 a 99,9 s, a incrementi di 0,1 s.
values_dt_text = L’antitermica: quando fa scendere il modello, contando dal lancio. Rosso se più breve del limite impostato.
values_dt_range = Da 1 a 720 s secondo il manuale. Non si possono inviare più di 10:55 min.
values_idleThrottle_text = F1Q: probabilmente la velocità a cui gira il motore mentre l’interruttore di lancio è tenuto premuto.
values_idleThrottle_range = La pagina presume da 0 a 100. L’unità non è nota.
values_memory_text = Un timer ha più memorie, ognuna con un programma. Quella selezionata è la memoria del prossimo volo. Per guardarne un’altra la si seleziona e poi si torna indietro; se questo viene interrotto, la pagina dice quale potrebbe essere la memoria del prossimo volo.
values_memory_range = Di solito quattro, da M1 a M4. I timer più vecchi ne hanno cinque.

## What a pilot checks before a flight.

checklist_lead = Spuntare ogni voce. Le spunte valgono per un volo e non vengono conservate.
checklist_items_memory = La memoria del prossimo volo è quella giusta.
checklist_items_dtTime = Ho detto il tempo di DT ad alta voce.
checklist_items_surfaces = Ala, piano di coda e direzionale sono ben fissati e stanno come devono.
checklist_items_battery = La batteria è carica e il suo connettore è inserito fino in fondo.
checklist_items_dtSeen = Ho visto il servo andare in posizione DT.
checklist_items_radioDt = Ho provato il DT via radio, se c’è.
checklist_items_switch = Ho premuto cinque volte l’interruttore di lancio, e ogni volta è tornato in posizione.
checklist_items_propeller = L’elica è ben fissata e gira libera. Davanti non c’è nessuno.
checklist_known_now = Prossimo volo: { $memory }, DT{"\u00a0"}{ $dt }, letto { $time }.
checklist_known_onceAt = All’ultima lettura, { $time }: { $memory }, DT{"\u00a0"}{ $dt }.
checklist_known_once = All’ultima lettura: { $memory }, DT{"\u00a0"}{ $dt }.
checklist_known_not = Non è noto che cosa contiene { $memory }. Leggerla prima di volare.
checklist_known_nothing = Nessun timer è stato letto. Connettersi per vedere qui la memoria del prossimo volo e il suo DT.
checklist_known_unwritten =
    { $count ->
        [one] { $count } modifica non è ancora nel timer.
       *[other] { $count } modifiche non sono ancora nel timer.
    }
checklist_left =
    { $count ->
        [one] Resta { $count } voce
       *[other] Restano { $count } voci
    }
checklist_done = Tutto spuntato. Buon volo.
checklist_again = Togli tutte le spunte

## Problems as a pilot sees them, and what to do.

troubles_symptoms_noAnswer_title = Il timer non risponde
troubles_symptoms_noAdapter_title = La pagina non trova l’adattatore
troubles_symptoms_refused_title = L’adattatore non si apre
troubles_symptoms_wrongValues_title = I valori sembrano sbagliati
troubles_symptoms_wrongValues_steps_1 = Guardare in cima alla pagina: quale memoria è mostrata, e quale è quella del prossimo volo?
troubles_symptoms_wrongValues_steps_2 = Premere «{ program_read }».
troubles_symptoms_wrongValues_steps_3 = I tempi calano di riga in riga? Allora la pagina chiede come leggerli.
troubles_symptoms_wrongValues_steps_4 = Con F1B e F1E confrontare i tempi con il programmatore portatile.
troubles_symptoms_cutOff_title = La scrittura è stata interrotta
troubles_symptoms_cutOff_steps_1 = Per ora non volare con questo modello. Connettersi: la pagina legge il timer, poi propone di finire la scrittura o di riscrivere i vecchi valori.
troubles_symptoms_cutOff_steps_2 = Ciò che il timer conteneva prima è nella vista «{ views_names_memories }», «{ backups_title }».
troubles_symptoms_noDt_title = Il DT non arriva, o arriva al momento sbagliato
troubles_symptoms_noDt_steps_1 = Guardare in cima alla pagina: si vede con quale memoria sarà il prossimo volo, e il suo DT. Un’altra memoria ha un altro DT.
troubles_symptoms_noDt_steps_2 = L’interruttore di lancio torna ogni volta in posizione? Finché è premuto la sequenza non comincia, e il DT non arriva.
troubles_symptoms_noDt_steps_3 = La batteria è carica, e il suo connettore è inserito fino in fondo? Se il timer non è in funzione, il DT non arriva.
troubles_symptoms_noDt_steps_4 = Tenere ben saldo il modello e premere la riga DT nella vista «{ views_names_bench }». Il servo va nella posizione DT, e libera ciò che trattiene?
troubles_symptoms_noDt_steps_5 = Togliere l’elica e lasciare che il timer arrivi alla fine. Non volare prima di aver visto il servo muoversi al tempo di DT.
troubles_symptoms_noMove_title = Un servo non si muove
troubles_symptoms_noMove_steps_1 = Tenere saldo il modello e premere nella vista «{ views_names_bench }» la riga della funzione in cui il servo deve muoversi. Non si muove nulla? Guardare connettore e batteria. Lì si muove, ma in volo no? Allora ha la stessa posizione della funzione precedente.
troubles_symptoms_noMove_steps_2 = Va in un punto diverso da quello della tabella? Forse certi timer memorizzano una posizione solo per la funzione in cui si trovano i servi. Allora la pagina propone di muovere i servi mentre scrive.
troubles_symptoms_noMove_steps_3 = Ronza, o si ferma troppo presto? Forse i rinvii lo bloccano: provare un movimento più piccolo.
troubles_symptoms_noMotor_title = Il motore non parte
troubles_symptoms_noMotor_steps_1 = Dopo un volo il timer blocca il motore. Per liberarlo, tenere saldo il modello e le mani lontane dall’elica: può partire. Poi tenere premuto il pulsante «{ bench_unlock }» nella vista «{ views_names_bench }».
troubles_symptoms_noMotor_steps_2 = L’interruttore di lancio è tornato in posizione? Finché è premuto, il motore gira solo al minimo.
troubles_symptoms_noMotor_steps_3 = Lo stop motore è impostato abbastanza tardi? Con 0,1 s il motore si ferma appena partito.
troubles_symptoms_noLibrary_title = I miei modelli e programmi non ci sono
troubles_symptoms_noLibrary_steps_1 = Svuotare il campo di ricerca, premere Archivio.
troubles_symptoms_noLibrary_steps_2 = Ogni browser, profilo e indirizzo ha una sua libreria; una finestra privata la cancella.
troubles_symptoms_noLibrary_steps_3 = Su un altro dispositivo, o se è andata persa: Importa, e il file dell’ultima esportazione.

## What to do, step by step, when a timer cannot be reached.

help_title = Che cosa fare
help_steps_programs = Chiudere le altre schede e i programmi che usano l’adattatore, come Arduino IDE, PuTTY, un programma per stampanti 3D o un configuratore per droni.
help_steps_replug = Scollegare l’adattatore, attendere cinque secondi, ricollegarlo. Se non basta, riavviare il computer.
help_steps_cable = Collegare l’adattatore direttamente, senza hub, e provare un altro cavo. Molti cavi USB servono solo a caricare.
help_steps_windows = Windows: aprire Gestione dispositivi. Un segno giallo sull’adattatore significa che manca il driver: collegarsi a Internet ed eseguire Windows Update.
help_steps_mac = Mac: consentire l’accessorio quando il Mac lo chiede. Un macOS vecchio ha bisogno del driver del produttore.
help_steps_linux = Linux può non permettere l’uso dell’adattatore. Eseguire questo comando, poi uscire dalla sessione e rientrare.
help_steps_linux-container = Il Linux di un Chromebook può aver preso l’adattatore. Disattivare l’adattatore nelle Impostazioni, in Ambiente di sviluppo Linux, Gestisci dispositivi USB.
help_steps_android = Su Android usare { android }. { restWorks }
help_steps_bluetooth = Bluetooth: associare l’adattatore nelle impostazioni del sistema (codice 1234 o 0000), tenerlo acceso e vicino, e disattivare il Bluetooth sugli altri dispositivi che lo usano.
help_steps_firefox-finds = Firefox non trova adattatori Bluetooth, e non ne trova nessuno se proviene dallo store di Ubuntu. Usare Chrome.
help_steps_firefox-reload = Firefox trattiene un adattatore che ha dato errore. Ricaricare questa pagina. Ciò che è stato inserito è conservato.
help_steps_switch = { link_stages_steps_switch }
help_steps_near = { link_stages_steps_near }
help_steps_battery = La batteria del timer è carica e collegata? Con la batteria scarica un timer sta nella posizione di DT.
help_steps_restarts = Alcuni adattatori si riavviano ogni volta che si apre la loro porta (DTR li riavvia), e per alcuni secondi non sentono nulla. In tal caso impostare la velocità in Opzioni, «{ ports_settings }»: la porta viene allora aperta una sola volta. La pagina stessa lascia DTR come lo imposta il browser.
help_steps_usual-settings = Aprire Opzioni, «{ ports_settings }», e premere «{ ports_reset }»: la pagina trova allora la velocità da sola.
help_steps_report = Se succede di nuovo: Opzioni, Esperto, Linea, «{ line_copyReport }». Inviarlo a:
help_steps_address = Aprire questo indirizzo in una scheda:
help_page = Tutti i passaggi, per ogni sistema

## For when the browser does not store, or give back, what it should.

keeping_title = Questo browser non conserva tutto.
keeping_notKept = Ciò che si inserisce, i backup e la nota di una scrittura interrotta durano solo finché questa pagina è aperta. Esportare la libreria. Poi chiudere le altre schede di questa pagina, o fare spazio su questo dispositivo.
keeping_notKnown = Il browser non dice se conserva ciò che si fa. Considerare tutto come non conservato, ed esportare la libreria.
keeping_oneTab = Usare una sola scheda di questa pagina.
keeping_emptied = Il browser ha cancellato ciò che conservava per questa pagina. Esportare ciò che si vede ancora.
keeping_export = Esporta la libreria…

## Stored data that cannot be read.

aside_title =
    { $count ->
        [one] Non è stato possibile leggere { $count } elemento. È messo da parte, non cancellato.
       *[other] Non è stato possibile leggere { $count } elementi. Sono messi da parte, non cancellati.
    }
aside_write = È compresa la nota di una scrittura interrotta: leggere il timer prima di volare.
aside_save = Salva in un file

## “2 models, 1 program”: only kinds that there are.

counted_models =
    { $count ->
        [one] { $count }{"\u00a0"}modello
       *[other] { $count }{"\u00a0"}modelli
    }
counted_settings =
    { $count ->
        [one] { $count }{"\u00a0"}programma
       *[other] { $count }{"\u00a0"}programmi
    }
counted_flights =
    { $count ->
        [one] { $count }{"\u00a0"}volo
       *[other] { $count }{"\u00a0"}voli
    }
counted_backups =
    { $count ->
        [one] { $count }{"\u00a0"}backup
       *[other] { $count }{"\u00a0"}backup
    }

## What was deleted a moment ago.

removed = Eliminato: { $what }.

## Deletes everything that this device keeps.

erase_open = Elimina tutto su questo dispositivo…
erase_lead = Elimina da questo browser tutti i modelli, i programmi, i voli, i backup, le modifiche non scritte e le scelte di questa pagina. Non si può annullare. I timer mantengono ciò che contengono.
erase_uncertain = Una scrittura è stata interrotta, e non è noto che cosa contiene quel timer. Senza la nota di quella scrittura questa pagina non può avvertire: leggere quel timer prima di volare.
erase_start = Elimina tutto
erase_running = Eliminazione
erase_failed = Non è stato possibile eliminare tutto. Chiudere le altre schede di questa pagina e riprovare, o eliminare i suoi dati nelle impostazioni del browser.

## For a page that is shown inside another page.

framed_title = Sidus Timer funziona solo in una scheda propria: un’altra pagina potrebbe coprire ciò che si vede del timer.
framed_open = Apri Sidus Timer in una scheda propria

## What is known about the content of a timer, and what is not.

knowledge_title = Incerto
knowledge_uncertain = Non è noto che cosa contiene { $memory }: { $values }.
knowledge_noFly = Non volare prima di averla letta.
knowledge_since = Scrittura interrotta (inizio: { $time }).
knowledge_thisMemory = la memoria corrente
knowledge_memoryOf = { $memory } ({ $timer })
knowledge_timer_here = { $name } { $firmware }
knowledge_timer_simulated = { $name } { $firmware } simulato
knowledge_otherTimer_here = un altro { $name } { $firmware }
knowledge_otherTimer_simulated = un altro { $name } { $firmware } simulato
knowledge_motorStop = stop motore
knowledge_either = { $name } è { $before } o { $goal }
knowledge_list =
    { $more ->
        [one] { $named }, e { $more }{"\u00a0"}altro{"\u00a0"}valore non è certo
       *[other] { $named }, e altri{"\u00a0"}{ $more }{"\u00a0"}valori non sono certi
    }
knowledge_and = { $first } e { $next }
knowledge_connect = Connetti e leggi
knowledge_forget = Dimentica…
knowledge_forgetSure = Dimenticare solo se quel timer è stato letto altrove, o non lo si ha più.
knowledge_forgetNow = Dimentica ora
knowledge_verified = Come nel timer, verificato { $time }
knowledge_readAt = Come nel timer, letto { $time }
knowledge_lastReadAt = Come all’ultima lettura, { $time }
knowledge_lastRead = Come all’ultima lettura
knowledge_ofSetting =
    { $changes ->
        [0] { $name }: salvato
        [one] { $name }: { $changes } modifica non salvata
       *[other] { $name }: { $changes } modifiche non salvate
    }
knowledge_changed = { $name }, modificato
knowledge_ofModel = { $name } di { $model }
knowledge_made = Programma nuovo, non ancora in un timer
knowledge_unknown = Non è noto che cosa contiene { $memory }
knowledge_unfinished =
    { $count ->
        [one] { $count } campo non ha ancora un valore
       *[other] { $count } campi non hanno ancora un valore
    }
knowledge_hints_now = I campi segnati sono diversi da ciò che il timer contiene.
knowledge_hints_onceAt = I campi segnati sono diversi dall’ultima lettura, { $time }.
knowledge_hints_once = I campi segnati sono diversi dall’ultima lettura.
knowledge_marks_now = era { $value }
knowledge_marks_once = ultima lettura { $value }
knowledge_notCertain = , ora non certo
knowledge_held_now = Nel timer
knowledge_held_once = Ultima lettura

## Why a program of the library or from a link cannot be opened now.

obstacles_busy = Questa pagina sta leggendo, scrivendo o cercando un timer. Attendere che finisca.
obstacles_following = I servi seguono le posizioni. Prima interrompere.
obstacles_not-fitting = { notFitting }

## Models and their saved programs.

library_unread = Il browser ora non può leggere la libreria. Chiudere le altre schede di questa pagina e riprovare.
library_empty_title = Ancora nessun modello
library_empty_lead = Un modello contiene i suoi programmi, con nomi e note. Sono conservati solo su questo dispositivo.
library_empty_hint = Creare un modello, o leggere un timer e salvarne il programma.
library_search_label = Cerca programmi
library_search_nothing = Nessun programma ha tutte queste parole.
library_models_title = Modelli
library_models_all = Tutti i modelli
library_models_make = Nuovo modello…
library_models_settings =
    { $count ->
        [one] { $count } programma
       *[other] { $count } programmi
    }
library_models_archive = Archivio ({ $count })
library_models_archived = archiviato
library_models_latest = Ultime modifiche
library_list_open = sullo schermo
library_model_timerClass = Classe
library_model_noClass = Non indicata
library_model_facts = Informazioni sul modello
library_model_noSettings = Ancora nessun programma.
library_model_servos = Servi
library_model_servosUnknown = Prima salvare un programma di questo modello.
library_model_servoWay = da { $low } a { $high } passi
library_model_archive = Archivia
library_model_unarchive = Togli dall’archivio
library_model_remove = Elimina il modello
library_model_withSettings =
    { $count ->
        [one] Insieme viene eliminato { $count }{"\u00a0"}programma. Annulla li riporta entrambi.
       *[other] Insieme vengono eliminati { $count }{"\u00a0"}programmi. Annulla li riporta tutti.
    }
library_setting_isOpen = Sullo schermo: mostralo
library_setting_loadAgain =
    { $count ->
        [one] Riapri: { $count } valore torna indietro
       *[other] Riapri: { $count } valori tornano indietro
    }
library_setting_tags = Etichette, separate da virgole
library_setting_from_typed = inserito
library_setting_from_timer = letto da un timer
library_setting_from_simulated = letto da un timer simulato
library_setting_from_backup = da un backup
library_setting_from_file = da un file
library_setting_from_link = da un link
library_setting_origin = { $source }, { $time }
library_setting_notShown = Non è stato possibile aprirlo. Riprovare.
library_setting_gone = Non è più nella libreria.
library_save_open = Salva…
library_save_over = Salva sopra { $program }
library_save_undo = Annulla il salvataggio di { $name }
library_save_crossing = Questi sono valori di { $from }. Salvarli nel modello { $to }.
library_save_asNew = Salva come nuovo…
library_save_taken = C’è già un programma { $program }. Inserire un altro nome, oppure:
library_save_replace = Salva sopra. I suoi valori restano come versione precedente.
library_save_name =
    { $of ->
        [program] Nome del programma
       *[model] Nome del modello
    }
library_save_namePlace = Per esempio: spareggio, calma
library_save_notSavable = Un campo non ha un valore. Prima va corretto.
library_save_state =
    { $changes ->
        [0] { $name }: salvato
        [one] { $name }: { $changes } modifica non salvata
       *[other] { $name }: { $changes } modifiche non salvate
    }
library_nameNeeded = Serve un nome.

## The log of the line.

line_empty = Nulla da mostrare.
line_unused = Sulla linea ancora nulla. Si può anche caricare una registrazione e riprodurla come timer.
line_all = Tutto
line_out = Al timer
line_in = Dal timer
line_damaged = Danneggiato
line_request = { $name } · { $letters }
line_reply = { $name }, risposta · { $letters }
line_echo = { $name }, eco · { $letters }
line_unknown = Lettera sconosciuta { $letter }
line_names_GETTIMERS = Leggi tempi
line_names_SETTIMERS = Scrivi tempi
line_names_GETSERVOPOS = Leggi posizioni
line_names_SETSERVO = Scrivi una posizione
line_names_MOVETOFUNC = Muovi servi
line_names_GETSWVER = Identifica
line_names_UNLOCK = Sblocca motore
line_names_JUMP2 = Salta
line_names_GETMEMORY = Quale memoria
line_names_SETMEMORY = Seleziona memoria
line_names_GETLOWRPM = Leggi minimo motore
line_names_SETLOWRPM = Scrivi minimo motore
line_rejected_noise = Danneggiato: rumore
line_rejected_length = Danneggiato: lunghezza impossibile
line_rejected_terminator = Danneggiato: manca la fine dove dovrebbe essere
line_rejected_checksum = Danneggiato: checksum errato
line_rejected_silence = Danneggiato: troncato
line_error_framing = Errore di linea: framing
line_error_parity = Errore di linea: parità
line_error_break = Errore di linea: break
line_error_overrun = Errore di linea: overrun, byte persi
line_error_other = Errore di linea di altro tipo
line_position = { $slot }, { $servo }: { $steps } passi
line_motorStop = stop motore { $time }
line_reserved = riservato { $time }
line_functions = funzioni { $times }
line_identity = { $name }, firmware { $firmware }, { $functions } e DT, { $memories }, { $servos }
line_memories =
    { $count ->
        [one] { $count } memoria
       *[other] { $count } memorie
    }
line_memoryUnsaid = Non dice quale.
line_idleThrottle = { $value }, unità non nota
line_idleThrottleUnsaid = Non dà un valore.
line_acknowledged = Confermato.
line_unreadable_wrong-length = Il contenuto è più lungo o più corto del dovuto.
line_unreadable_unknown-command = Il significato non è noto.
line_unreadable_unexpected-reply = Risponde a un’altra richiesta.
line_unreadable_bad-identity = Ciò che dice del timer non può essere giusto.
line_unreadable_identity-needed = Si può leggere quando il timer ha detto che cosa è.
line_unreadable_out-of-range = Un suo valore non può essere giusto.
line_unreadable_not-an-integer = { line_unreadable_out-of-range }
line_unreadable_wrong-count = { line_unreadable_out-of-range }
line_unreadable_wrong-type = { line_unreadable_out-of-range }
line_unreadable_unknown-word = Il contenuto non si può leggere.
line_unreadable_bad-capture = { line_unreadable_unknown-word }
line_unreadable_bad-file = { line_unreadable_unknown-word }
line_unreadable_bad-link = { line_unreadable_unknown-word }
line_unreadable_newer-version = { line_unreadable_unknown-word }
line_unreadable_too-large = { line_unreadable_unknown-word }
line_unreadable_duplicate = { line_unreadable_unknown-word }
line_goOn = Continua
line_came =
    { $number ->
        [one] In pausa. Da allora { $number } voce.
       *[other] In pausa. Da allora { $number } voci.
    }
line_clear = Svuota
line_unidentified = sconosciuto
line_load = Carica…
line_filter = Mostra
line_searchHint = nome o hex
line_counts_out = { $count } al timer
line_counts_in = { $count } dal timer
line_counts_damaged =
    { $count ->
        [one] { $count } danneggiato
       *[other] { $count } danneggiati
    }
line_counts_errors =
    { $count ->
        [one] { $count } errore di linea
       *[other] { $count } errori di linea
    }
line_recording =
    { $entries ->
        [one] { $name }: una registrazione di { $entries } voce.
       *[other] { $name }: una registrazione di { $entries } voci.
    }
line_replay = Riproduci come timer
line_cannotReplay = Non si può riprodurre: il timer non dice mai che cosa è.
line_back = Torna alla linea dal vivo
line_noRecordingAt = Riga { $line }: previsto un tempo in secondi, > o <, e byte in hex.
line_noRecording = Questo file non è una registrazione.
line_send_title = Invia una trama a mano
line_send_lead = La pagina aggiunge lunghezza e checksum.
line_send_bytes = Lettera e dati, in hex
line_send_faults_hex = Inserire due cifre hex per ogni byte, da 0 a 9 o da A a F.
line_send_faults_too-long = Una trama porta al massimo 252 byte.
line_send_preview = Viene inviato
line_send_send = Invia…
line_send_confirmTitle = Inviare questa trama al timer?
line_send_danger = I servi possono muoversi, l’elica può partire, e ciò che il timer contiene può cambiare. Dopo, il timer viene letto di nuovo.
line_send_confirm = Sì, invia una volta
line_send_sending = Invio
line_send_answered = Risposta:
line_send_unanswered = Nessuna risposta. Ciò che la trama chiedeva potrebbe essere avvenuto comunque.
line_copyReport = Copia rapporto

## From the ports to a timer that answers.

link_portNames_ftdi = Adattatore FTDI
link_portNames_cp210x = Adattatore CP210x (Silicon Labs)
link_portNames_ch340 = Adattatore CH340 (WCH)
link_portNames_pl2303 = Adattatore PL2303 (Prolific)
link_portNames_bluetooth = Bluetooth
link_portNames_usb = Adattatore USB
link_portNames_other = Porta seriale
link_stages_choosing = Scegliere l’adattatore del timer
link_stages_openingLong_title = L’adattatore è lento ad aprirsi
link_stages_openingLong_advice = Bluetooth: accendere l’adattatore e tenerlo vicino. Cavo: scollegarlo e ricollegarlo.
link_stages_asking = Interrogazione a { $rate } baud.
link_stages_noAnswer = Nessuna risposta da { $seconds } s. Questa pagina continua a chiedere e prosegue da sola.
link_stages_open = L’adattatore è aperto
link_stages_steps_switch = Svegliare il timer: premere brevemente il suo interruttore
link_stages_steps_near = Tenere la testina a infrarossi a meno di 20 cm, al riparo dal sole
link_stages_steps_other = Il timer è su un altro adattatore?
link_refused = La pagina riprova per 15 secondi. Un altro programma può avere l’adattatore.
link_heard_title = Si sente qualcosa, ma nessun timer risponde.
link_heard_advice = Svegliare il timer e avvicinare la testina, al riparo dal sole, o scegliere un altro adattatore.
link_slow_title = Un timer risponde, ma troppo lentamente.
link_slow_advice = I suoi byte arrivano uno alla volta a { $rate } baud, con pause così lunghe che nessuna risposta è completa in tempo. Questa pagina non può leggerlo. Provare un altro adattatore, o un cavo al posto del Bluetooth.
link_itSaid = È arrivato: { $bytes } («{ $text }»).
link_trySelectBare = Prova senza checksum corretto
link_lost_title = La connessione con l’adattatore è andata persa.
link_lost_advice = Collegarlo, o avvicinarlo: la pagina prosegue da sola. Ciò che è stato inserito è conservato.
link_status_off = Non connesso
link_status_opening = Connessione
link_status_searching = Ricerca del timer
link_status_away = Connessione persa
link_status_closing = Disconnessione

## The known ports, and how they are opened.

ports_title = Adattatori noti
ports_forget = Dimentica
ports_settings = Impostazioni seriali
ports_settingsHint = Solo per un adattatore particolare. La pagina trova la velocità da sola.
ports_rate = Velocità
ports_findRate = Automatica
ports_baud = { $rate } baud
ports_parity = Parità
ports_parities_none = Nessuna
ports_parities_even = Pari
ports_parities_odd = Dispari
ports_stopBits = Bit di stop
ports_dtr = DTR
ports_rts = RTS
ports_signals_leave = Come imposta il browser
ports_signals_on = Attivo
ports_signals_off = Inattivo
ports_reset = Impostazioni usuali

## What is known about the connected timer. Its numbers are in the report.

aboutTimer_title = Questo timer
aboutTimer_damage = Danni visti sulla linea
aboutTimer_crowd = Nel fascio infrarosso potrebbe esserci un altro timer o programmatore. Da allora due letture devono coincidere.
aboutTimer_found = Che cosa ha fatto di diverso
aboutTimer_nothingFound = Finora nulla: ha fatto tutto ciò che è stato chiesto nel modo usuale.
aboutTimer_quirkNames_timers-reply-66 = Risponde con la lettera di un altro comando.
aboutTimer_quirkNames_unlock-reply-6a = { aboutTimer_quirkNames_timers-reply-66 }
aboutTimer_quirkNames_memory-unknown = Non dice quale memoria è corrente.
aboutTimer_quirkNames_memory-impossible = { aboutTimer_quirkNames_memory-unknown }
aboutTimer_quirkNames_bare-checksum = Sul minimo motore non risponde come al solito.
aboutTimer_quirkNames_times-big-endian = I suoi tempi calano. Scambiando i due byte di ognuno crescerebbero.
aboutTimer_quirkNames_servo-first = Quando si scrive una posizione, prende il servo prima della funzione.
aboutTimer_quirkNames_servo-unanswered = Non ha risposto quando è stata scritta una posizione.
aboutTimer_quirkNames_times-rounded = Arrotonda i tempi.
aboutTimer_quirkNames_memories-from-one = Conta le memorie a partire da 1.
aboutTimer_quirkNames_positions-unchanged = Ha confermato delle posizioni, ma non le ha mantenute.
aboutTimer_quirkNames_echo = L’adattatore rimanda indietro ciò che gli si invia.
aboutTimer_quirkNames_idle-throttle-unanswered = { aboutTimer_quirkNames_bare-checksum }
aboutTimer_quirkNames_identity-unusual = Ciò che dice di sé ha byte non noti.
aboutTimer_quirkNames_idle-throttle-malformed = { aboutTimer_quirkNames_bare-checksum }
aboutTimer_quirkNames_replies-alike = Le sue risposte ad alcune richieste sono danneggiate, ognuna nello stesso modo.
aboutTimer_assumed = Differenze note
aboutTimer_assumedHint = Ricordate per questo adattatore e questo tipo di timer.
aboutTimer_forget = Dimentica le differenze note
aboutTimer_assumptions_bigEndianTimes = I due byte di ogni tempo sono scambiati
aboutTimer_assumptions_servoFirst = { aboutTimer_quirkNames_servo-first }
aboutTimer_assumptions_memoriesFromOne = { aboutTimer_quirkNames_memories-from-one }
aboutTimer_assumptions_bareChecksumRequests = «Seleziona memoria» e «scrivi minimo motore» vengono inviati senza checksum corretto
aboutTimer_assumptions_positionsNeedMove = Le posizioni si mantengono solo per la funzione in cui si trovano i servi

## Which memory flies next, and what is known about the others.

nextFlight_badge = prossimo volo
nextFlight_onScreen = Questa è { $memory }.
nextFlight_named = { $memory }, prossimo volo
nextFlight_other = Prossimo volo con { $memory }.
nextFlight_last = { $memory } era la memoria corrente quando il timer ha risposto l’ultima volta. Sarà quella del prossimo volo, se nel frattempo non ne è stata selezionata un’altra.
nextFlight_original = Al momento della connessione era { $original }.
nextFlight_originalUnknown = Non è noto quale fosse al momento della connessione.
nextFlight_unknown = Non è noto con quale memoria sarà il prossimo volo.
nextFlight_asked = L’ultima selezionata è { $memory }.
nextFlight_back = Torna a { $original }
nextFlight_leaving_title = Prima di disconnettersi
nextFlight_leaving_back = Torna a { $original } e disconnetti
nextFlight_leaving_failed = Il timer non è tornato a { $original }. È ancora connesso.

## The last reading of a memory that is not current.

look_read = { $memory }, letta { $time }
look_notRead = { $memory } non è stata letta
look_either = Forse
look_or = oppure
look_lead = Solo da guardare. Prossimo volo con { $current }.
look_edit = Modifica { $memory }
look_look = Guarda { $memory }
look_hint = Così { $memory } viene selezionata e letta, poi si torna a { $current }.
look_fly = Scegli { $memory } per il volo
look_show = Mostra { $memory }

## Jobs over several memories, and the backups.

memories_copy = Copia { $from } in { $to }
memories_restore = Ripristina un backup
memories_restoreAll = Ripristina tutti i { $count }…
memories_plans_screen =
    { $keepsThrottle ->
        [true] { $to } conterrà i tempi e le posizioni sullo schermo. Prima si fa un backup di ciò che { $to } contiene ora. Il minimo motore resta com’è.
       *[false] { $to } conterrà i tempi e le posizioni sullo schermo. Prima si fa un backup di ciò che { $to } contiene ora.
    }
memories_plans_copy = { $to } conterrà i tempi e le posizioni di { $from }, appena letti. Prima si fa un backup di ciò che { $to } contiene ora.
memories_plans_restore = In { $names } viene scritto il backup ({ $time }). Prima si fa un backup di ciò che c’è ora.
memories_atEnd = Alla fine il prossimo volo sarà di nuovo con { $current }.
memories_refused = { $memory }: non si può scrivere nulla, perché nessun software può inviare questi valori.
memories_untouched = { $memory }: nulla è stato scritto.
memories_stopped = Ciò che non era ancora scritto è com’era.

## All memories of a timer at a glance.

overview_readAll = Leggi e conserva tutte
overview_copyTo = Copia in…
overview_compareWith = Confronta con { $memory }
overview_readAt = letta { $time }
overview_notCertain = Incerta: una scrittura in questa memoria è stata interrotta. Mostrata com’era prima di quella scrittura.
overview_edited = Mostrata e copiata come la contiene il timer, senza le modifiche fatte qui.
overview_same = Contengono lo stesso.
overview_differs =
    { $count ->
        [one] { $count } valore è diverso.
       *[other] { $count } valori sono diversi.
    }

## How the timer writes its times: the question that no reading can answer.

byteOrder_title = I tempi di questo timer calano di riga in riga.
byteOrder_advice = Crescerebbero se i due byte di ogni tempo fossero scambiati. Confrontare con ciò che si sa del timer, e scegliere prima di scrivere.
byteOrder_keep = Sono giusti come mostrati
byteOrder_exchange = Scambiali e rileggi

## Why there is no connection.

connection_unsupported_title = { unsupportedHere_title }
connection_unsupported_advice = { unsupportedHere_advice }
connection_insecure_title = Il browser qui non consente le porte seriali.
connection_insecure_advice = { restWorks }
connection_policy_title = Il server di questa pagina vieta le porte seriali.
connection_policy_advice = { restWorks }
connection_nothing-chosen_title = Nessun adattatore è stato scelto.
connection_nothing-chosen_advice = Premere Connetti e scegliere l’adattatore. Se non è nell’elenco, aiutano i passaggi qui sotto.
connection_not-allowed_title = { connection_insecure_title }
connection_not-allowed_advice = Consentire le porte seriali per questa pagina nelle impostazioni del browser, poi premere di nuovo Connetti.
connection_busy_title = L’adattatore non si apre.
connection_busy_advice = Di solito lo ha un altro programma o un’altra scheda. Chiuderli, poi premere di nuovo Connetti.
connection_bad-settings_title = L’adattatore non accetta queste impostazioni.
connection_bad-settings_advice = { help_steps_usual-settings }
connection_unplugged_title = L’adattatore non è raggiungibile.
connection_unplugged_advice = Scollegarlo, ricollegarlo e premere Connetti. Ciò che è stato inserito è conservato.
connection_bad-reply_title = { link_heard_title }
connection_bad-reply_advice = { link_heard_advice }
connection_lost_title = { connection_unplugged_title }
connection_lost_advice = { connection_unplugged_advice }

## Why a job with the timer has ended.

timer_no-answer_title = Il timer non ha risposto.
timer_no-answer_advice = Premere brevemente l’interruttore del timer, tenere la testina a meno di 20 cm e riprovare. Ciò che è stato inserito è conservato.
timer_bad-reply_title = La risposta del timer non può essere giusta.
timer_bad-reply_advice = Riprovare. Se succede di nuovo: Opzioni, Esperto, Linea, «{ line_copyReport }».
timer_unstable_title = La linea è troppo disturbata per fidarsene.
timer_unstable_advice = Avvicinare la testina a infrarossi, al riparo dal sole, e riprovare.
timer_crowded_title = Nel fascio infrarosso potrebbe esserci più di un timer.
timer_crowded_advice = Tenere lontani altri timer e programmatori, e rileggere.
timer_other-memory_title = La memoria corrente non è quella sullo schermo.
timer_other-memory_advice = Rileggere prima di scrivere.
timer_memory-unknown_title = Questo timer non dice quale memoria è corrente.
timer_memory-unknown_advice = Perciò questa pagina non può guardare un’altra memoria e tornare indietro. Si può leggere e scrivere quella corrente.
timer_memory-left_title = La memoria del prossimo volo potrebbe non essere più la stessa.
timer_memory-left_advice = Questa pagina non è riuscita a tornare a quella che era corrente. Connettersi di nuovo e scegliere la memoria giusta per il prossimo volo prima di volare.
timer_other-timer_title = Non è il timer che ha risposto prima.
timer_other-timer_advice = La pagina lo legge. Guardare che cosa contiene prima di scrivere.
timer_stale_title = Il timer non contiene ciò che era mostrato.
timer_stale_advice = Nulla è stato scritto. Guardare che cosa cambierebbe ora una scrittura.
timer_changed_title = Il timer contiene valori diversi da prima.
timer_changed_advice = Qualcos’altro lo ha cambiato, o questo è un altro timer. Le modifiche fatte qui sono conservate: guardare le differenze prima di scrivere.
timer_stood-still_title = Questa pagina è rimasta ferma durante il lavoro.
timer_stood-still_advice = Non è stato inviato altro: ora potrebbe esserci un altro timer. Rileggere.
timer_too-slow_title = Questo timer risponde troppo lentamente.
timer_too-slow_advice = Le sue risposte richiedono più di 3 secondi, perciò questa pagina non può distinguere quale appartiene a quale domanda. Non è stato inviato altro. Provare un altro adattatore, o un cavo al posto del Bluetooth.
timer_undecided_title = { byteOrder_title }
timer_undecided_advice = { byteOrder_advice }
timer_serious_title = I controlli hanno trovato qualcosa di grave.
timer_serious_advice = { timer_stale_advice }
timer_busy_title = Qualcosa su questa pagina o su questo computer usa l’adattatore.
timer_busy_advice = Nulla è stato inviato. Disconnettere e connettere di nuovo. Ciò che è stato inserito è conservato.
timer_port-lost_title = { link_lost_title }
timer_port-lost_advice = { link_lost_advice }
timer_aborted_title = Fermato.
timer_aborted_advice = Rileggere per vedere che cosa contiene il timer.
timer_closed_title = Disconnesso.
timer_closed_advice = Premere Connetti per continuare. Ciò che è stato inserito è conservato.

## Replies that are no noise, which is random.

alike_title = Ogni risposta a { $request } è danneggiata nello stesso modo.
alike_advice = Non è rumore: il timer o il suo adattatore forma queste risposte in un modo che non è noto. Con Esperto attivo nelle opzioni, aprire Linea e premere «{ line_copyReport }». Inviare il rapporto ai curatori del progetto (github.com/sidus-timer/sidus-timer/issues).
alike_part = Solo da guardare: { $values }. Tutto il resto non è noto.

## Messages that are not about errors.

notes_back_title = Le modifiche sono di nuovo qui.
notes_back_advice = Confrontarle con ciò che il timer contiene, poi scriverle o annullarle.
notes_back-uncertain_title = { notes_back_title }
notes_back-uncertain_advice = Non è noto se sono state scritte. Connettersi al timer e leggerlo prima di volare.
notes_moved_title = { timer_changed_title }
notes_moved_advice = { timer_changed_advice }
notes_timer-moved_title = { timer_changed_title }
notes_timer-moved_advice = { timer_changed_advice }
notes_kept_title = Le modifiche sono conservate su questo dispositivo.
notes_kept_advice = Non sono adatte a ciò che è stato letto ora. Tornano quando si rilegge quella memoria; le elenca anche la pagina iniziale.
notes_other-kind_title = Ora c’è un altro tipo di timer.
notes_other-kind_advice = { timer_other-timer_advice }
notes_write-completed_title = La scrittura interrotta è completa.
notes_write-completed_advice = Il timer è stato letto di nuovo e contiene tutto ciò che si doveva scrivere.
notes_nothing-written_title = { write_refused }
notes_nothing-written_advice = {""}
notes_not-backed-up_title = { write_unkept_title }
notes_not-backed-up_advice = { keeping_notKept }
notes_select-unanswered_title = Il timer non ha risposto alla selezione di una memoria.
notes_select-unanswered_advice = Alle altre richieste risponde. Riprovare, o inviare la richiesta senza checksum corretto.
notes_backed-up_title = Tutte le memorie sono state lette, e di ognuna è conservato un backup.
notes_backed-up_advice = {""}
notes_strays_title = { timer_crowded_title }
notes_strays_advice = { timer_crowded_advice }
notes_made-laid_title = La tabella mostra il programma aperto qui, non ciò che il timer contiene.
notes_made-laid_advice = Nulla è stato scritto. Le differenze sono segnate. «{ undo }» mostra ciò che il timer contiene.
notes_unexpected_title = Qualcosa è andato storto in questa pagina.
notes_unexpected_advice = Non è stato inviato altro. Ricaricare la pagina. Ciò che è stato inserito è conservato.

## The flight of the program, and what the servos of the model move.

preview_title = Anteprima del volo
preview_guessed = Non in scala.
preview_nameServos = Dai nomi ai servi…
preview_play = Riproduci
preview_speed = Velocità
preview_time = Tempo del volo
preview_launch = Lancio
preview_at = { $what } a { $time }
preview_sketch = Il modello visto di lato, e il suo direzionale dall’alto
preview_motor_true = Salita, motore in moto
preview_motor_false = Planata, motore fermo
preview_flies = In volo
preview_comesDown = DT: il modello scende
preview_duties_rudder = Direzionale
preview_duties_tailplane = Piano di coda
preview_duties_wing = Ala
preview_duties_release = Disco o filo del DT
preview_duties_other = Altro
preview_duties_none = Non usato
preview_naming_lead = Che cosa muove ogni servo, e tra quali passi. Su e giù si riferiscono al bordo d’uscita.
preview_naming_duty = { $servo } muove
preview_naming_name = Nome di ciò che { $servo } muove
preview_naming_low = { $servo }, un estremo in passi
preview_naming_high = { $servo }, l’altro estremo in passi
preview_naming_from = da
preview_naming_to = a
preview_naming_sense = { $servo }, effetto di più passi
preview_naming_otherSense_false = più passi: su
preview_naming_otherSense_true = più passi: giù
preview_naming_rudderSense_false = più passi: destra
preview_naming_rudderSense_true = più passi: sinistra

## The sheet of a program.

print_paper = Carta
print_what = Sul foglio
print_parts_lines = Righe per scrivere
print_parts_code = Codice QR
print_nothing = Scegliere programmi della libreria, o aprirne uno.
print_choose = Programmi in questa stampa: { $chosen }
print_clear = Togli tutti
print_simulated = timer simulato
print_warnings = Da guardare prima di volare
print_notes = Note
print_codeHint = La fotocamera di un telefono apre questo programma, senza la nota.
print_unfinished =
    { $count ->
        [one] { $count } campo non ha ancora un valore: è stampato l’ultimo
       *[other] { $count } campi non hanno ancora un valore: è stampato l’ultimo
    }
print_printed = Stampato { $date }

## The model in the strip.

recognition_which = Quale modello?
recognition_change = Modello { $model }: indica quale modello è

## A memory with the pilot's name for it: M2 “fly-off”.

memoryNames_named = { $memory } «{ $name }»

## What an earlier job left behind on a timer.

recovery_title = Una scrittura precedente è stata interrotta.
recovery_when = Scrittura in { $memory }, inizio: { $time }.
recovery_nothing =
    { $missing ->
        [one] Il timer contiene ciò che conteneva prima: nulla è stato scritto, manca { $missing } modifica.
       *[other] Il timer contiene ciò che conteneva prima: nulla è stato scritto, mancano { $missing } modifiche.
    }
recovery_part =
    { $missing ->
        [one] Di quella scrittura il timer contiene { $values }; { $missing } valore è ancora come prima.
       *[other] Di quella scrittura il timer contiene { $values }; { $missing } valori sono ancora come prima.
    }
recovery_foreign =
    { $count ->
        [one] { $count } valore nel timer non è né di prima né di quella scrittura. È un altro timer, o qualcos’altro ha cambiato il timer?
       *[other] { $count } valori nel timer non sono né di prima né di quella scrittura. È un altro timer, o qualcos’altro ha cambiato il timer?
    }
recovery_sure = Questa pagina non distingue i timer dello stesso tipo. Continuare solo se è il timer di quella scrittura.
recovery_finish = Finisci la scrittura…
recovery_goBack = Riscrivi i vecchi valori…
recovery_leave = Lascia così
recovery_otherTimer = È un altro timer
recovery_sameTimer = È lo stesso timer: mostra che cosa si doveva scrivere
recovery_compare = Confronta
recovery_before = Com’era
recovery_elsewhere = Una scrittura in { $memory } di un timer di questo tipo è stata interrotta. Leggere { $memory } per vedere che cosa contiene.
recovery_left = Il lavoro sulle memorie è stato interrotto. Ora il prossimo volo è con { $current }. Prima era con { $original }.
recovery_mayFly = Il prossimo volo potrebbe essere con { $memory }: la selezione è stata interrotta.
recovery_mayNotFly = Il lavoro sulle memorie è stato interrotto. Il prossimo volo potrebbe essere con una memoria diversa da { $original }.
recovery_unknownMemory = una memoria sconosciuta

## The backups.

backups_title = Backup
backups_empty = Prima di ogni scrittura, questa pagina conserva qui ciò che il timer contiene.
backups_reasons_write = prima di una scrittura
backups_reasons_memories = tutte le memorie

## How the page looks.

theme_title = Colori
theme_names_system = Sistema
theme_names_light = Chiaro
theme_names_dark = Scuro
theme_names_sun = Sole

## The settings of the page.

settings_look = Aspetto
settings_expert = Esperto: mostra la linea
settings_expertHint = La linea mostra ogni byte tra questa pagina e il timer. Il banco offre un salto che non è documentato.
settings_kept = Che cosa conserva questo dispositivo

## A saved program as a link and a QR code, and back.

share_offer_lead = Il link contiene l’intero programma. Nulla viene inviato a un server.
share_offer_link = Link
share_offer_copy = Copia link
share_offer_scan = Puntare la fotocamera dell’altro dispositivo su questo codice, o inviare il link.
share_offer_qr = Codice QR di «{ $name }»
share_offer_cut = La fine della nota non entra nel codice QR. Il link contiene la nota intera.
share_offer_tooLong = Troppo lungo per un codice QR. Inviare il link.
share_received_title = Un programma da un link
share_received_lead = Finora questa pagina lo mostra soltanto. Nulla è conservato, e nulla è scritto in un timer.
share_received_known = La libreria ha già questi valori: { $name }.
share_received_modelChoice = Conserva sotto
share_received_newModel = Nuovo modello «{ $name }»
share_received_keep = Conserva in libreria
share_received_discard = Non conservare
share_received_unwritten = Ciò che è stato inserito è conservato: lo riporta Annulla, o la pagina iniziale.
share_damaged_title = Questo link non si può leggere.
share_damaged_bad = È tagliato o danneggiato, o non è di questa pagina. Farselo mandare di nuovo.
share_paste_title = Incolla un link…
share_paste_lead = La fotocamera di un telefono apre un codice QR da sola. Qui si può incollare un link.
share_paste_show = Mostra
share_paste_notLink = Non è un link a un programma.

## A DT for trimming that is about to be flown. The page asks before the pilot disconnects, and at a contest round.

shortDt_held = Il DT di { $memory } è { $dt }.
shortDt_heldHere = Il DT è { $dt }.
shortDt_ask =
    { $remembered ->
        [true] Rimetterlo a { $back }?
       *[false] Impostarlo a { $back }?
    }
shortDt_putBack =
    { $remembered ->
        [true] Rimetti il DT a { $back }…
       *[false] Imposta il DT a { $back }…
    }
shortDt_disconnect = Disconnetti così: { $memory }, DT{"\u00a0"}{ $dt }
shortDt_disconnectHere = Disconnetti così: DT{"\u00a0"}{ $dt }
shortDt_blocked = Qualcosa che è stato inserito non si può ancora scrivere. Correggerlo prima di rimettere il DT.
shortDt_settings_limit = Un DT è breve se è meno di
shortDt_settings_hint = Un DT più breve è rosso, e la pagina chiede prima di disconnettersi. Con il limite a 0 s non chiede mai.

## The start, before anything was read.

start_title = Impostare il timer Sidus
start_lead = Leggere che cosa contiene, cambiarlo, scriverlo e vederlo verificato. Nulla lascia questo dispositivo.
start_adapter = Collegare l’adattatore
start_firefox = Firefox chiede prima un permesso, e poi la porta ogni volta che questa pagina viene caricata.
start_android = Un telefono si connette via Bluetooth; per un cavo servono Android { firstVersions_androidCable } e Chrome { firstVersions_android }.
start_readyOffline = Pronta offline
start_install = Installa
start_picture_example = Esempio: un F1Q
start_picture_kept = Conservato { $time }
start_models_title = I miei modelli
start_models_none = Conservare i programmi di ogni modello, con note.
start_models_programs =
    { $count ->
        [one] { $count } programma
       *[other] { $count } programmi
    }
start_models_library = Apri la libreria
start_programs_title = Da finire
start_programs_made = { $timer }, nuovo
start_programs_changesOf = { $timer }, modifiche
start_programs_sure = Eliminarlo per sempre?
start_simulatedTitle = Nessun timer a portata di mano?
start_simulatedLead = Uno simulato risponde come uno vero, byte per byte.
start_simulated = Prova un timer { $name } simulato
start_backups =
    { $count ->
        [one] { $count } backup, conservato prima di una scrittura. L’ultimo: { $last }.
       *[other] { $count } backup, conservati prima di una scrittura. L’ultimo: { $last }.
    }

## The dialog that makes a program without a timer.

newProgram_title = Nuovo programma…
newProgram_timerClass = Classe
newProgram_functions = Funzioni, senza lancio e DT
newProgram_servos = Servi
newProgram_from = Inizia con
newProgram_beginnings_usual = Tempi usuali, servi al centro
newProgram_beginnings_nothing = Tutti i tempi e le posizioni a 0
newProgram_caution = Qui le posizioni del modello non sono note. Impostarle tutte prima di scrivere.
newProgram_make = Crea il programma

## The picture of a program over time.

timeline_title = Diagramma
timeline_compareBefore = prima che seguissero
timeline_picture = Posizioni dei servi nel tempo
timeline_description = { $servos } e { $functions } nel tempo, DT a { $dt }. La tabella ha tutti i valori.
timeline_descriptionMotor = { $servos } e { $functions } nel tempo, DT a { $dt }, stop motore a { $motorStop }. La tabella ha tutti i valori.
timeline_functions =
    { $count ->
        [one] { $count } funzione
       *[other] { $count } funzioni
    }
timeline_servos =
    { $count ->
        [one] { $count } servo
       *[other] { $count } servi
    }
timeline_keysToEdit = Le frecce vanno da un segno all’altro e da un servo all’altro, più e meno ingrandiscono e riducono, 0 mostra tutto. Invio va alle maniglie: le frecce le spostano, Esc torna indietro.
timeline_ask = Puntare o toccare per leggere
timeline_finer = Più fine
timeline_steps =
    { $position ->
        [one] { $position } passo
       *[other] { $position } passi
    }
timeline_stepsUnit = passi
timeline_notKnown = Non noto: i tempi calano
timeline_tools = Vista
timeline_zoomIn = Ingrandisci
timeline_zoomOut = Riduci
timeline_fit = Mostra tutto
timeline_passedOver = { $slot }: saltata, perché { $next } arriva allo stesso tempo.
timeline_goesBack = { $next } viene prima di { $slot }. Non è noto che cosa fa il timer nella parte ombreggiata.

## A new version of the page.

update_ready = È pronta una nuova versione.
update_waits = Si avvia quando il timer è disconnesso e nulla è aperto o non salvato.
update_take = Usala ora
update_news = Novità

## The version of this page.

aboutPage_title = Questa pagina
aboutPage_version = Sidus Timer { $version }.
aboutPage_offline = L’intera pagina è su questo dispositivo: funziona senza rete.
aboutPage_notOffline = La pagina non è ancora conservata su questo dispositivo: aprirla una volta con la rete.
aboutPage_licences = Licenze

## The views of the page and the links between them.

views_title = Viste
views_names_program = Programma
views_names_memories = Memorie
views_names_bench = Banco
views_names_library = Libreria
views_names_line = Linea
views_names_settings = Opzioni
views_names_print = Stampa
views_names_help = Aiuto
views_print = Stampa…
views_share = Condividi…
views_noTimer_memories = Connettere un timer per vedere le sue memorie. I backup sono qui sotto.
views_noTimer_bench = Connettere un timer per muovere i suoi servi.

## The strip above every view: the timer, its memory, DT, motor stop, and what is known.

strip_panel = Memorie e altro
strip_tried =
    { $count ->
        [one] { $count } provata
       *[other] { $count } provate
    }
strip_notCertain = incerto
strip_asRead = ultima lettura
strip_notValid = non valido
strip_ofSetting =
    { $changes ->
        [0] salvato
        [one] { $changes } non salvata
       *[other] { $changes } non salvate
    }
strip_made = in nessun timer

## The list of commands.

palette_title = Comandi
palette_search = Inserire che cosa si vuole fare
palette_nothing = Nessun comando ha questo nome, o ora non è possibile.
palette_ctrl = Ctrl+{ $key }

## In place of a part of the page that is being loaded.

parts_coming = Caricamento
parts_failed = Non è stato possibile caricare una parte di questa pagina.
parts_again = Riprova

## Which model it is.

whichModel_recognition_same = È { $model }, con i valori dell’ultima volta ({ $when }).
whichModel_recognition_like =
    { $count ->
        [one] È simile a { $model }, { $count } valore è diverso. È { $model }?
       *[other] È simile a { $model }, { $count } valori sono diversi. È { $model }?
    }
whichModel_recognition_several = Potrebbe essere { $models }. Quale modello è?
whichModel_or = { $names } o { $last }
whichModel_others =
    { $count ->
        [one] { $count } altro
       *[other] altri { $count }
    }
whichModel_recognition_unknown = Questo timer qui non è noto. Quale modello è?
whichModel_recognition_yes = Sì, { $model }
whichModel_recognition_choose = Scegli…
whichModel_recognition_ok = OK
whichModel_recognition_dialog_title = Quale modello è?
whichModel_recognition_dialog_lead = Un timer non conosce il suo modello. La pagina confronta ciò che contiene con ciò che ha visto l’ultima volta in ogni modello.
whichModel_recognition_dialog_said = È stato indicato che è { $model }.
whichModel_recognition_dialog_moreMemories = Leggere anche le altre memorie: possono distinguere i modelli.
whichModel_recognition_dialog_none = Nessun modello così di questa classe.
whichModel_recognition_dialog_newModel = Un nuovo modello
whichModel_recognition_dialog_keep = Conserva come nuovo modello
whichModel_memoryNames_label = Nome di { $memory }
whichModel_memoryNames_give = Nome
whichModel_crossing_title = Questi sono valori di { $from }, ma questo timer sembra quello di { $to }.
whichModel_crossing_advice = Con i valori di un altro modello si può perdere questo. Guardare il modello che si ha davanti.
whichModel_crossing_confirm = Scrivere valori di { $from } nel timer di { $to }.
whichModel_crossing_memoryOf = { $memory } di { $model }

## A write, from the difference to the verdict.

write_title = Scrittura nel timer
write_lead = Ecco che cosa cambia: { $memory }. Tutto il resto rimane com’è.
write_target = Scrivi in
write_nothing = Nessuna differenza. Il timer viene riletto e confrontato.
write_field = Valore
write_from = Contiene
write_to = Conterrà
write_wasRead = Letto prima
write_moved_model_title = Questo timer ora sembra appartenere a un altro modello.
write_moved_model_advice = Nulla è stato scritto. Guardare i nomi dei modelli.
write_moved_edits_title = Il programma è cambiato da quando questo è stato mostrato.
write_unkept_title = Questo dispositivo non ha potuto conservare un backup di ciò che il timer contiene ora.
write_unkept_advice = Questa memoria è ancora com’era. Continuare senza backup?
write_sideBySide = Valori: { $names }
write_withoutCopy = Continua senza backup
write_safety = L’elica è smontata o il modello è tenuto fermo, e il timer non è armato.
write_acknowledge = Ho letto questo e voglio scrivere comunque.
write_stillToTick = Ancora da spuntare: { $ticks }.
write_ticks_model = altro modello
write_ticks_warnings = avvisi
write_ticks_safety = elica
write_move_why = Questo timer sembra mantenere le posizioni solo per la funzione in cui si trovano i servi. Se i servi non si muovono, probabilmente non manterrà queste.
write_move_label = Portare i servi a ogni funzione prima di memorizzare le sue posizioni.
write_move_hint = Tenere saldo il modello. Nulla deve ostacolare i servi.
write_move_notHeld_title = Il timer ha confermato le posizioni, ma non le ha mantenute.
write_move_notHeld_advice = Probabilmente questo timer le mantiene solo per la funzione in cui si trovano i servi. Scrivere di nuovo, lasciando che i servi vadano a ogni funzione.
write_move_again = Scrivi di nuovo…
write_start =
    { $count ->
        [0] Rileggi e confronta
        [one] Scrivi { $count } modifica
       *[other] Scrivi { $count } modifiche
    }
write_stages_read = Lettura
write_stages_write = Scrittura
write_stages_verify = Rilettura
write_stages_repair = Correzione
write_stopping = Si ferma dopo questa richiesta
write_stoppingBack = Si ferma: prima torna alla memoria precedente
write_verified_title = Verificato.
write_verified_advice = Il timer è stato riletto e contiene ciò che era mostrato.
write_verdict = { $memory }: verificato { $time }
write_asItIs = com’è
write_insteadOf = invece di { $value }
write_wanted = Da scrivere
write_readBack = Riletto
write_differs_title = Il timer non ha preso tutti i valori.
write_differs_advice = Il timer è stato riletto. Qui contiene altri valori:
write_unknown_title = Non è certo che cosa contiene il timer.
write_unknown_advice = Non è stato possibile rileggere il timer per intero. Rileggere, poi scrivere ciò che è ancora diverso. Le modifiche fatte qui sono conservate.
write_cut = La scrittura è stata interrotta: { $memory }.
write_strayed_title = { $memory } è diventata corrente durante la scrittura.
write_strayed_advice = Alcuni valori potrebbero essere ora in { $memory }. Leggerla, e controllarla tutta prima di volare con essa.
write_refused = Nulla è stato scritto.
write_status_differs = diverso
write_status_unknown = non noto
write_putBack = cambiato dal timer stesso, rimesso com’era

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
        [start] Lancio
        [dt] DT
       *[function] Funzione { $slot }
    }
within_slot =
    { $kind ->
        [start] lancio
        [dt] DT
       *[function] funzione { $slot }
    }
within_idleThrottle = minimo motore
slotShort =
    { $kind ->
        [start] Lancio
        [dt] DT
       *[function] { $slot }
    }
about = { $name }:
previous = Precedente
next = Avanti
pause = Pausa
less = { $what }: meno
moreOf = { $what }: più
seconds = { $time }{" "}s
times_minutes = { $minutes }{" "}min
times_minutesSeconds = { $minutes }{" "}min { $seconds }{" "}s
times_units_s = s
times_units_min = min
times_figure = { $text } { $unit }
times_asSeconds = { $seconds }{" "}s, { $clock }
times_meaning = Che cosa si intende: { $field }
header_firmware = firmware { $firmware }
header_simulated = simulato
header_connect = Connetti
header_choosePort = Scegli un altro adattatore
header_closeProgram = Chiudi programma
header_disconnect = Disconnetti
header_stop = Ferma
program_tableCaption = Tempo e posizioni dei servi di ogni funzione
program_slot = Funzione
program_time = Tempo
program_memory = Memoria
program_memoryUnknown = Questo timer non dice quale memoria è corrente, perciò non è noto con quale sarà il prossimo volo.
program_memoryOpen = Non è noto con quale memoria sarà il prossimo volo. Sceglierne una per il prossimo volo, o rileggere.
program_dt = DT
program_motorStop = Stop motore
program_motor = Motore
program_idleThrottle = Minimo motore
program_throttle = Minimo
program_idleThrottleUnit = unità non nota
program_reserved = riservato { $time }
program_timeOf = { $slot }, tempo
program_motorStopTime = Stop motore, tempo
program_positionOf = { $slot }, { $servo }
program_shortDt = DT breve
program_changes =
    { $count ->
        [one] { $count } modifica
       *[other] { $count } modifiche
    }
program_undoAll = Annulla tutto
program_read = Rileggi
program_connectAndWrite = Connetti e scrivi…
program_write =
    { $count ->
        [0] Scrivi…
        [one] Scrivi { $count } modifica…
       *[other] Scrivi { $count } modifiche…
    }
program_picture = Grafico
program_table = Tabella
program_blocked = Non si può ancora scrivere nulla. { $field }: { $why }
program_findings = Controlli
program_noFindings = Nulla di insolito.
program_absolute = Mostrato a partire dal lancio. Non è noto se questo timer conta dal lancio o dalla funzione precedente.
program_severity_error = Non scrivibile
program_severity_serious = Grave
program_severity_warning = Insolito
program_reading = Lettura del timer
program_selecting = Cambio di memoria
otherTab_holdsSince = Sidus Timer è aperto in un’altra scheda, da: { $since }.
otherTab_holds = Sidus Timer è aperto in un’altra scheda.
otherTab_takeOver = Usalo qui
otherTab_busy = L’altra scheda sta lavorando con il timer. Si apre qui appena ha finito.
otherTab_gone = L’altra scheda non risponde. Chiuderla, poi ricaricare questa pagina.
disturbed = Mancano risposte o sono danneggiate: il timer è sveglio, e la testina a infrarossi è vicina, al riparo dal sole? Questo finisce al più tardi tra { $seconds } s.
cancel = Annulla
close = Chiudi
copy = Copia
copied = Copiato.
copyByHand = Il browser non permette a questa pagina di copiare. Copiare da qui.
dismiss = Nascondi
done = Fatto
undo = Annulla
open = Apri
save = Salva
delete = Elimina
notNow = Non ora
label_language = Lingua
label_name = Nome
label_note = Nota
label_model = Modello
label_search = Cerca
noModel = Nessun modello
more =
    { $count ->
        [one] E { $count } altro.
       *[other] E altri { $count }.
    }
showMore =
    { $count ->
        [one] Mostra { $count } altro
       *[other] Mostra altri { $count }
    }
of = { $button }: { $name }
notFitting = Non è adatto al timer connesso. Disconnettere per aprirlo.
notKept = Questo browser non lo ha conservato: va perso quando si chiude questa pagina.

## The walk through the open questions of docs/protocol.md with a real timer.

settle_title = Chiarisci con il timer
settle_lead = Non tutto è noto su come parlano questi timer. In quindici minuti questo timer chiarisce ciò che è ancora aperto. Ogni valore provato viene rimesso com’era. Tenere a portata di mano il programmatore portatile.
settle_safe = L’elica è smontata o il motore è scollegato, e il timer non è armato.
settle_danger = Ora qualcosa può muoversi. L’elica è smontata, o il motore scollegato? Guardare ancora una volta.
settle_blocked = Prima risolvere ciò che dice l’avviso in cima alla pagina, e tenere ciò che è stato provato o rimettere com’era.
settle_readIt = Leggi il timer
settle_which = Quale mostra il programmatore portatile?
settle_tryHint = Muovere i servi con i pulsanti e attendere che siano fermi. Poi provare una posizione: viene cambiata e rimessa com’era entro pochi secondi. Osservare i servi.
settle_tryIt = Prova una posizione
settle_moved = La vecchia posizione è tornata: la rilettura lo conferma. Si è mosso un servo quando è stata provata quella nuova?
settle_ask = Chiedi con quattro zeri
settle_unknown = Non lo so
settle_send = Invia il file con questo modulo
settle_names_order = Il byte basso di un tempo viene per primo
settle_names_unit = I tempi sono in centesimi di secondo
settle_names_count = I tempi contano dal lancio
settle_names_memories = La prima memoria ha il numero 0
settle_names_zeros = Quattro zeri bastano
settle_names_layout = La funzione viene prima del servo
settle_names_stores = Le posizioni si mantengono a qualsiasi funzione
settle_names_moves = Una posizione scritta muove il suo servo
settle_names_unlock = Lettera che risponde a UNLOCK
settle_names_delay = Tempo usuale di una risposta
settle_names_reserved = Tempo riservato, come letto
settle_yes = Sì
settle_no = No
settle_unnumbered = Nessun numero è indicato
settle_there = Solo dove si trovano i servi
settle_delay = { $ms } ms
settle_open = Non chiarito
