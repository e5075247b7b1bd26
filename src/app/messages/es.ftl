### Todo lo que dice la página, en español de España: una traducción de en.ftl, con los mismos nombres. Translated without
### a pilot of that language; corrections welcome (docs/translating.md).

## Moving servos and motor from the page.

bench_slots = Ir a
bench_elsewhere = Los servos y el motor trabajan con { $memory }, la memoria del próximo vuelo. Muestre { $memory } para moverlos.
bench_trim = Reglaje: { $slot }
bench_at = Posición de los servos: { $slot }
bench_atNone = No se sabe dónde están los servos.
bench_moveMaybe = No ha llegado respuesta. Aun así, los servos pueden haberse movido. Mire el modelo.
bench_unlocked = El motor está desbloqueado. La hélice puede arrancar.
bench_unlockMaybe = No ha llegado respuesta. Aun así, el motor puede estar desbloqueado. Manténgase lejos de la hélice.
bench_jumped = El temporizador ha confirmado el salto.
bench_here = servos aquí
bench_waits = Espera a «Escribir».
bench_bring = Llevar los servos a { $slot }
bench_follow = Los servos siguen las posiciones
bench_followHint = Primero la página lee el temporizador y conserva una copia de seguridad. Después, cada posición que se cambia en la fila donde están los servos se almacena al momento en el temporizador, y su servo se mueve.
bench_followingNow = Los servos siguen: una posición que se cambia en la fila donde están se almacena al momento en el temporizador.
bench_stopFollowing = Dejar de seguir
bench_ended_over = Los servos ya no siguen las posiciones.
bench_ended_memory = Los servos ya no siguen: otra memoria es la actual, o puede que lo sea.
bench_ended_strayed = Mientras los servos seguían, otra memoria ha pasado a ser la actual. Puede haber tomado algunas de las posiciones: revísela entera antes de volar con ella.
bench_ended_unlike = Los servos ya no siguen: el temporizador no ha hecho lo que ha confirmado.
bench_ended_failed = Los servos ya no siguen: el temporizador no ha respondido.
bench_notTaken = { $field } contiene { $held }, no { $wanted }.
bench_beside =
    { $more ->
        [0] Han cambiado además: { $named }.
        [one] Han cambiado además: { $named }; y { $more } valor más.
       *[other] Han cambiado además: { $named }; y { $more } valores más.
    }
bench_triedHere =
    { $more ->
        [0] Probado: { $named }.
        [one] Probado: { $named }; y { $more } posición más.
       *[other] Probado: { $named }; y { $more } posiciones más.
    }
bench_triedAndWaiting =
    { $waiting ->
        [0] Probado en el temporizador: { $tried }
        [one] Probado en el temporizador: { $tried }; { $waiting } espera a «Escribir»
       *[other] Probado en el temporizador: { $tried }; { $waiting } esperan a «Escribir»
    }
bench_triedIn = Se han probado posiciones en { $memory }.
bench_decide = ¿Dejar lo que se ha probado, o reponer lo que el temporizador contenía antes?
bench_keep = Dejarlo así
bench_putBack = Reponer lo anterior…
bench_unlock = Mantener pulsado: UNLOCK
bench_unlockHold = No suelte
bench_unlockHint = La hélice puede arrancar. Sujete el modelo, mantenga las manos lejos de la hélice, y después pulse sin soltar.
bench_experimental = Experimental
bench_jumpHint = Salta a la función que sigue a un DT anticipado. Su efecto exacto no está documentado: los servos pueden moverse.
bench_jump = Saltar…
bench_jumpSure = Enviar el salto ahora

## The log of flights.

flights_title = Vuelos
flights_empty_title = Aún no hay vuelos registrados.
flights_empty_advice = Lea o escriba un temporizador y pulse «{ flights_flying_button }».
flights_failed = El navegador no puede leer ahora la biblioteca. Cierre otras pestañas de esta página e inténtelo de nuevo.
flights_flying_button = Vuelo así
flights_flying_purpose = Registra un vuelo con lo que contiene el temporizador.
flights_flying_logged = Vuelo registrado { $time }
flights_flying_fillIn = Completar
flights_flying_again = Otro vuelo así
flights_row_round = Manga { $round }
flights_row_wind = { $wind } m/s
flights_row_temperature = { $degrees } °C
flights_row_noResult = sin resultado
flights_row_changed = { $values } cambiados
flights_row_otherTimer = otro temporizador
flights_totals_flights =
    { $count ->
        [one] { $count } vuelo
       *[other] { $count } vuelos
    }
flights_totals_best = mejor { $time }
flights_totals_average = media { $time }
flights_filter_of = Vuelos de { $name }
flights_filter_clear = Mostrar todos
flights_form_title = Vuelo
flights_form_result = Resultado
flights_form_resultHint = Segundos, o minutos como 2:58.
flights_form_readAs = { $time }, { $seconds } s
flights_form_propose = Anotar { $facts }
flights_form_full = Máximo, 180 s
flights_form_round = Manga
flights_form_flyOff = Fly-off
flights_form_wind = Viento
flights_form_windUnit = m/s
flights_form_temperature = Temperatura
flights_form_temperatureUnit = °C
flights_form_when = Fecha, lugar, modelo
flights_form_date = Fecha y hora
flights_form_noOffset = No se conoce la zona horaria del campo: esta es la hora de este dispositivo.
flights_form_place = Lugar
flights_form_flown = Con qué se ha volado
flights_form_open = Abrir su programa
flights_form_unreadable_not-a-number = No es un número.
flights_form_unreadable_not-a-time = No es un tiempo: introduzca segundos como 178, o minutos como 2:58.
flights_form_unreadable_too-fine = { unreadable_too-fine }
flights_form_range = De { $min } a { $max } { $unit }.
flights_form_shortDt = En este vuelo el DT era { $dt }.
flights_score_open = Puntuación
flights_score_maximum = Máximo de cada manga
flights_score_none = Sin un máximo, cada resultado cuenta entero.
flights_score_maximumOf = Máximo: { $round }
flights_score_counted = Cuenta (s)
flights_score_notCounted = no cuenta
flights_score_count = Contar este
flights_score_noRound = sin manga
flights_score_total = Total
flights_score_copy = Copiar como texto
flights_csv_save = Guardar como tabla (CSV)
flights_csv_columns_date = Fecha
flights_csv_columns_time = Hora
flights_csv_columns_zone = Zona horaria
flights_csv_columns_place = Lugar
flights_csv_columns_model = Modelo
flights_csv_columns_setting = Programa
flights_csv_columns_timerClass = Clase de temporizador
flights_csv_columns_memory = Memoria
flights_csv_columns_dt = DT (s)
flights_csv_columns_motorStop = Paro de motor (s)
flights_csv_columns_wind = Viento (m/s)
flights_csv_columns_temperature = Temperatura (°C)
flights_csv_columns_round = Manga
flights_csv_columns_result = Resultado (s)
flights_csv_columns_maximum = Máximo (s)
flights_csv_columns_note = Nota
flights_section_all = Todos sus vuelos

## Values that are unusual, or cannot be written.

findings_time-not-whole = { unreadable_not-a-whole-number }
findings_time-out-of-range = Debe estar entre { $min } y { $max }.
findings_position-not-whole = { unreadable_not-a-whole-number }
findings_position-out-of-range = Debe estar entre { $min } y { $max }.
findings_throttle-not-whole = { unreadable_not-a-whole-number }
findings_throttle-out-of-range = Debe estar entre { $min } y { $max }.
findings_position-as-read = Leído como { $value }, por encima del último paso, { $max }. Se queda así si no se cambia.
findings_time-falls = Llega antes que la función de arriba ({ $previous }).
findings_time-repeats = El mismo tiempo que la función de arriba, { $previous }.
findings_position-never-reached = El mismo tiempo que la función de arriba, { $previous }. Nunca se alcanzan las posiciones de la función de arriba.
findings_motor-stop-after-dt = El motor se para después del DT ({ $dt }): el modelo baja con el motor en marcha.
findings_motor-run-long = El motor funciona más tiempo que { $limit }, el límite para F1Q.
findings_time-outside-manual = El manual admite de { $min } a { $max }.
findings_time-too-fine = El manual indica incrementos de { $step }: el temporizador puede redondear.
findings_dt-short = Más corto que { $limit }.
findings_dt-moves-nothing = Al llegar el DT no se mueve ningún servo: el temporizador no hace bajar el modelo.
findings_throttle-unusual = Más de { $limit } es inusual. No se conoce la unidad.
findings_class-unknown = No se conoce la clase «{ $timerClass }»: no se han comprobado sus reglas.

## Why a text in a field is no value.

unreadable_empty = Vacío: introduzca un valor.
unreadable_not-a-time = No es un tiempo: introduzca segundos como 12,5, o minutos como 2:05.
unreadable_too-fine = Más preciso que una centésima de segundo.
unreadable_not-a-whole-number = Debe ser un número entero.
unreadable_ambiguous = Se puede leer de varias maneras: elija una.

## For a page that cannot reach a timer here.

restWorks = Todo lo demás, salvo la conexión, también funciona aquí.

## What an Android phone needs.

firstVersions_android = 148
firstVersions_androidBluetooth = 138
firstVersions_lastBluetoothOnly = 147
firstVersions_androidCable = 17
android = Chrome { firstVersions_android } o posterior (de { firstVersions_androidBluetooth } a { firstVersions_lastBluetoothOnly } solo por Bluetooth); un cable necesita Android { firstVersions_androidCable }

## For every browser about which nothing more is known. docs/connection.md names the first versions.

unsupportedHere_title = Este navegador no puede acceder a un temporizador.
unsupportedHere_advice = En un ordenador, use una versión actual de Chrome, Edge, Opera o Firefox; en un teléfono, Chrome para Android. { restWorks }

## Replaces the sentence above where the browser's name tells more.

unsupported_brave_title = Brave solo accede a un temporizador si usted lo permite.
unsupported_brave_advice = Abra brave://flags/#brave-web-serial-api, elija Enabled y pulse Relaunch. { restWorks }
unsupported_ios_title = Ningún navegador de un iPhone o iPad puede acceder a un temporizador.
unsupported_ios_advice = Use un ordenador, o Chrome en un teléfono Android. { restWorks }
unsupported_android_title = { unsupportedHere_title }
unsupported_android_advice = En Android, use { android }. { restWorks }

## What a saved program held before it was saved over.

versions_title = Versiones anteriores
versions_until = Hasta:{"\u00a0"}{ $when }
versions_changed =
    { $more ->
        [0] después { $change }
       *[other] después { $change } y { $more }{"\u00a0"}más
    }
versions_otherLayout = después valores para otro temporizador
versions_same = El programa guardado contiene esto ahora.
versions_goBack = Volver a esta

## Two programs side by side.

compare_title = Comparar
compare_open = Comparar…
compare_second = con
compare_screen = En la pantalla
compare_timer = Temporizador, { $memory }
compare_groups_now = Ahora
compare_groups_settings = Programas guardados
compare_setting = { $model } · { $name }
compare_backup = { $memory } · { $when }
compare_backupOf = { $model } · { $memory } · { $when }
compare_nothing = Este dispositivo no tiene otro programa de esta clase y estructura.
compare_take = Tomar
compare_takeOf = Tomar { $value } para { $field }
compare_takeHint = «Tomar» copia un valor en el programa de la pantalla.

## How a backup differs from what its timer holds.

modelBackups_same = como en el temporizador { $when }
modelBackups_differs =
    { $count ->
        [one] { $count } valor distinto del temporizador { $when }
       *[other] { $count } valores distintos del temporizador { $when }
    }
modelBackups_now = ahora


## Undo, redo, and edits of many fields at once.

edits_redoButton = Rehacer
edits_undo = Deshacer { $step }
edits_redo = Rehacer { $step }
edits_steps_change = cambio de { $what }
edits_steps_shift = desplazamiento desde { $what } de { $by }
edits_steps_step-servo = { $what } en { $steps }
edits_steps_step-servo-from = { $what } en { $steps }, desde { $from }
edits_steps_paste = pegado de { $count }
edits_steps_fill = relleno de { $count }
edits_steps_revert-all = reposición de todo
edits_steps_open = apertura de { $what }
edits_steps_keep-tried = confirmación de lo probado
edits_opened = «{ $name }»
edits_openedUnnamed = otro programa
edits_refused_start = La salida no tiene un tiempo que cambiar.
edits_refused_later-out-of-range = Una función posterior ya no estaría entre { $min } y { $max }.
edits_refused_unreadable = Lo impide un texto que no es un valor. Corríjalo primero.
edits_refused_interval-disagrees = Este intervalo no encaja con los tiempos de las dos filas.
edits_refused_no-place = El programa no tiene ese lugar.
edits_refused_twice = Este lugar aparece dos veces, con valores distintos.
edits_refused_too-large = La tabla es demasiado grande: se leen como máximo { $cells } celdas. El resto se ha omitido.
edits_beforeLaunch = Esto sería antes del lanzamiento.
edits_nothingDone = No se ha cambiado nada.
edits_cells =
    { $count ->
        [one] { $count } valor
       *[other] { $count } valores
    }
edits_change = { $field }: { $from } → { $to }
edits_field_putBack = Reponer { $field }
edits_field_putBackTo = Devolver { $field } a { $figure }
edits_sheet_title = Teclas para { $field }
edits_sheet_erase = Borrar la última cifra
edits_sheet_putBack = Reponer
edits_sheet_selectRange = Seleccionar rango
edits_sheet_goTo = Ir a { $name }
edits_table_explain = Qué son los valores
edits_table_interval = Tras
edits_table_countedFrom = desde { $row }
edits_table_switch = Tiempo o Tras
edits_table_intervalOf = Intervalo, { $slot }
edits_table_range_title = Rango seleccionado
edits_table_range_pick = Toque ahora otra celda.
edits_table_range_size = { $cells }, { $columns }
edits_table_range_functions =
    { $count ->
        [one] { $count } función
       *[other] { $count } funciones
    }
edits_table_range_rows =
    { $count ->
        [one] { $count } fila
       *[other] { $count } filas
    }
edits_table_range_columns =
    { $count ->
        [one] { $count } columna
       *[other] { $count } columnas
    }
edits_table_range_paste = Pegar…
edits_table_range_fillDown = Rellenar abajo
edits_table_range_clipboardClosed = No hay nada que pegar que esta página pueda ver. Toque el primer campo y pegue allí.
edits_table_tools = Herramientas de { $name }
edits_stepServo_title = Todas las posiciones de { $servo }
edits_stepServo_now = Ahora { $position }
edits_stepServo_nowRange = Ahora de { $lowest } a { $highest }
edits_stepServo_by = Cuánto, en pasos
edits_stepServo_step = Mover
edits_stepServo_which = Cuáles
edits_stepServo_all = Todas las funciones
edits_stepServo_from = Desde { $slot }
edits_stepServo_stops =
    { $count ->
        [one] { $steps }: { $what } se queda en { $at }.
       *[other] { $steps }: { $what } se quedan en { $at }.
    }
edits_shift_open = Desplazar…
edits_shift_from =
    { $isLast ->
        [true] { $row }
       *[false] { $row } y siguientes
    }
edits_shift_by = Cuánto, en segundos
edits_shift_earlier = Adelantar
edits_shift_later = Retrasar
edits_shift_moveDt = Mover también el DT
edits_shift_function = función { $number }
edits_shift_functionRange = funciones { $first } a { $last }
edits_shift_functions = funciones { $numbers }
edits_shift_moved =
    { $later ->
        [true] Retrasado { $time }{" "}s
       *[false] Adelantado { $time }{" "}s
    }
edits_pasting_asks = No se conocen estos nombres. Indique qué significan:
edits_pasting_choose = Elegir
edits_pasting_leaveOut = Omitir
edits_pasting_table = Qué va dónde
edits_pasting_lead =
    { $count ->
        [0] Esto no cambia nada.
        [one] Esto cambia { $count } valor.
       *[other] Esto cambia { $count } valores.
    }
edits_pasting_reading = { $field }: «{ $text }» se lee como { $time }.
edits_pasting_problems = No se puede pegar:
edits_pasting_place = Fila { $row }, columna { $column } del texto copiado
edits_pasting_problem = { $place }: { $reason }
edits_pasting_problemOf = { $place }, «{ $text }»: { $reason }
edits_pasting_apply = Pegar
edits_presets_title = DT habituales
edits_presets_use = DT { $time }
edits_presets_refused = Introduzca tiempos como 20 s o 2:30, hasta 10:55 min, 24 como máximo.
edits_fix = Poner { $value }
edits_fixOf = Poner { $value }: { $field }

## The library as files: export, import, and the reminder to export.

files_export_all = Exportar todo…
files_export_one = Exportar…
files_export_downloaded = «{ $name }» va a sus descargas: { $what }. Compruebe que está allí.
files_export_without = sin { $kind }
files_export_kinds_models = modelos
files_export_kinds_settings = programas
files_export_kinds_flights = vuelos
files_export_partly = «{ $name }» no está completo. Contiene { $what }. El navegador no puede leer ahora: { $missing }. Cierre otras pestañas de esta página y exporte de nuevo.
files_export_and = { $first } y { $next }
files_export_tooLarge = La biblioteca es demasiado grande para un solo archivo. Exporte sus modelos uno a uno.
files_export_failed = No se ha podido crear el archivo. Vuelva a cargar la página e inténtelo otra vez.
files_import_button = Importar…
files_import_title = Importar { $name }
files_import_lead = Guardado { $date }. Contiene { $what }.
files_import_leadNothing = Guardado { $date }. No contiene nada.
files_import_ignored =
    { $count ->
        [one] { $count } entrada es de una versión más nueva de esta página y se omite.
       *[other] { $count } entradas son de una versión más nueva de esta página y se omiten.
    }
files_import_nothing = Ya tiene todo esto.
files_import_differs = Diferencias
files_import_ways_newer = Tomar lo más nuevo
files_import_ways_both = Quedarse con ambos
files_import_itself = el propio modelo
files_import_flightOf = vuelo: { $day }
files_import_wayText_newer = Se queda lo que aquí es más nuevo o tiene la misma fecha.
files_import_wayText_both = Se quedan ambos. El del archivo recibe un número tras su nombre.
files_import_unknownModel = Un modelo que no está aquí
files_import_group_fresh = Nuevo: { $what }
files_import_group_same = Igual: { $what }
files_import_group_fileNewer = Más nuevo en el archivo: { $what }
files_import_group_deviceNewer = No más nuevo en el archivo: { $what }
files_import_group_fileName = { $file } (aquí: { $here })
files_import_take =
    { $count ->
        [0] Nada que importar
       *[other] Importar { $count }
    }
files_import_allStays = Nada del archivo es más nuevo. Elija «{ files_import_ways_both }» para importarlo también.
files_import_done = Importado de «{ $name }»: { $what }.
files_import_undo = Deshacer la importación
files_import_undone = Se ha deshecho la importación. Los cambios posteriores se quedan.
files_refused_title = No se puede importar { $name }
files_refused_nothing = No se ha importado nada.
files_refused_again = Exporte el archivo de nuevo, o pida otro a quien lo envió.
files_refused_fault = Línea{"\u00a0"}{ $line }: hay { $found }.
files_refused_faultIn = Línea{"\u00a0"}{ $line }, { $place }: hay { $found }.
files_refused_wanted = Se esperaba:
files_refused_place_entry =
    { $kind ->
        [models] Modelo «{ $name }»
        [settings] Programa «{ $name }»
       *[flights] Vuelo «{ $name }»
    }
files_refused_place_unnamed =
    { $kind ->
        [models] Modelo { $number } del archivo
        [settings] Programa { $number } del archivo
       *[flights] Vuelo { $number } del archivo
    }
files_refused_place_function = función { $number }
files_refused_damaged = El archivo está dañado o incompleto.
files_refused_files_too-large = El archivo es demasiado grande para una biblioteca.
files_refused_files_gone = No se ha podido leer el archivo. Elíjalo de nuevo.
files_refused_files_several = Importe los archivos de uno en uno.
files_refused_format = No es un archivo de biblioteca de Sidus Timer.
files_refused_newer = Lo ha creado una versión más nueva de esta página. Vuelva a cargar la página con conexión a la red.
files_reminder =
    { $changes ->
        [one] { $changes } cambio de la biblioteca está solo en este dispositivo. Si pierde el dispositivo, solo un archivo lo recupera.
       *[other] { $changes } cambios de la biblioteca están solo en este dispositivo. Si pierde el dispositivo, solo un archivo los recupera.
    }

## For the time before the other sentences are loaded.

first_failed = La página no está completa. ¿Hay red?
first_again = Volver a cargar

## What a system shows of the installed page: public/manifest.webmanifest has the same in English.

manifest_description = Ajusta los temporizadores Sidus F1Q, F1B y F1E de vuelo libre: lee lo que contiene un temporizador, recoge sus cambios, los escribe, los relee y compara. Conserva sus modelos y programas en este dispositivo. Funciona sin red.
manifest_connect = Conectar un temporizador
manifest_connectShort = Conectar
manifest_connectWhat = La página inicial, con Conectar a mano
manifest_library = Biblioteca
manifest_libraryWhat = Los modelos y sus programas
manifest_simulated = Temporizador simulado
manifest_simulatedWhat = La página inicial, con los temporizadores simulados a mano
manifest_pictures_program = El programa de un temporizador, con dos cambios marcados
manifest_pictures_write = Qué cambiará una escritura, antes de escribir
manifest_pictures_programPhone = El programa entero en un teléfono
manifest_pictures_writePhone = Qué cambiará una escritura, en un teléfono

## The help inside the page.

guide_pages_checklist = Chequeo
guide_pages_trouble = Problemas
guide_pages_words = Valores
guide_pages_steps = Primeros pasos
guide_nav = Páginas de ayuda

## What a new pilot is told.

firstSteps_1 = Leer: pulse Conectar, despierte el temporizador, acerque el cabezal de infrarrojos. Leer no cambia nada ni mueve nada.
firstSteps_2 = Escribir: introduzca los valores nuevos, pulse Escribir, mire cada diferencia. «Verificado» significa: el temporizador se ha leído de nuevo y contiene lo que usted quiere.
firstSteps_3 = Volar: en la parte de arriba de la página se ve con qué memoria será el próximo vuelo, y su DT. La página no necesita red, y nada sale de este dispositivo.

## The values of a program, with unit and range.

values_function_text = Una etapa del vuelo: a su tiempo, cada servo va a su posición. Para saltarla, dele las posiciones de la función anterior.
values_function_range = Normalmente salida, nueve funciones y DT.
values_time_text = Cuándo empieza una función, contado desde el lanzamiento. Introduzca 12,5 o 2:05. En F1B y F1E no se sabe desde dónde cuenta el temporizador.
values_time_range = Según los manuales. F1Q: de 0,1 a 99,9 s. F1B: de 0,01 a 9,99 s para las funciones 1 y 2, después de 0,1 a 99,9 s. F1E: no se conoce.
values_after_text = El tiempo desde la función anterior. Todas las funciones posteriores se desplazan con él, el DT no.
values_position_name = Posición
values_position_text = Dónde está un servo. El ángulo de un paso depende del servo y del varillaje: pruébelo en el banco.
values_position_range = De 0 a 130 pasos.
values_motorStop_text = F1Q: cuándo se para el motor, contado desde el lanzamiento. Ningún servo se mueve con él.
values_motorStop_range = Según el manual, de 0,1 a 99,9 s, en incrementos de 0,1 s.
values_dt_text = El destermalizador: cuándo hace bajar el modelo, contado desde el lanzamiento. En rojo si es más corto que su límite.
values_dt_range = De 1 a 720 s según el manual. No se pueden enviar más de 10:55 min.
values_idleThrottle_text = F1Q: probablemente la velocidad a la que gira el motor mientras se mantiene pulsado el interruptor de lanzamiento.
values_idleThrottle_range = La página supone de 0 a 100. No se conoce la unidad.
values_memory_text = Un temporizador tiene varias memorias, cada una con un programa. La seleccionada es la del próximo vuelo. Para mirar otra, se selecciona y se vuelve; si eso se interrumpe, la página dice cuál puede ser la del próximo vuelo.
values_memory_range = Normalmente cuatro, de M1 a M4. Los temporizadores más antiguos tienen cinco.

## What a pilot checks before a flight.

checklist_lead = Marque cada punto. Las marcas valen para un vuelo y no se conservan.
checklist_items_memory = La memoria del próximo vuelo es la correcta.
checklist_items_dtTime = He dicho en voz alta el tiempo de DT.
checklist_items_surfaces = Ala, estabilizador y timón están bien sujetos y en su posición.
checklist_items_battery = La batería está cargada y su conector está metido hasta el fondo.
checklist_items_dtSeen = He visto el servo moverse a la posición de DT.
checklist_items_radioDt = He probado el DT por radio, si lo hay.
checklist_items_switch = He pulsado cinco veces el interruptor de lanzamiento, y cada vez ha vuelto a su sitio.
checklist_items_propeller = La hélice está bien sujeta y gira libre. No hay nadie delante.
checklist_known_now = Próximo vuelo: { $memory }, DT{"\u00a0"}{ $dt }, leído { $time }.
checklist_known_onceAt = En la última lectura, { $time }: { $memory }, DT{"\u00a0"}{ $dt }.
checklist_known_once = En la última lectura: { $memory }, DT{"\u00a0"}{ $dt }.
checklist_known_not = No se sabe qué contiene { $memory }. Léala antes de volar.
checklist_known_nothing = No se ha leído ningún temporizador. Conecte para ver aquí la memoria del próximo vuelo y su DT.
checklist_known_unwritten =
    { $count ->
        [one] { $count } cambio aún no está en el temporizador.
       *[other] { $count } cambios aún no están en el temporizador.
    }
checklist_left =
    { $count ->
        [one] Queda { $count } punto
       *[other] Quedan { $count } puntos
    }
checklist_done = Todo marcado. Buen vuelo.
checklist_again = Quitar todas las marcas

## Problems as a pilot sees them, and what to do.

troubles_symptoms_noAnswer_title = El temporizador no responde
troubles_symptoms_noAdapter_title = La página no encuentra el adaptador
troubles_symptoms_refused_title = El adaptador no se abre
troubles_symptoms_wrongValues_title = Los valores parecen incorrectos
troubles_symptoms_wrongValues_steps_1 = Mire en la parte de arriba de la página: ¿qué memoria se muestra, y cuál es la del próximo vuelo?
troubles_symptoms_wrongValues_steps_2 = Pulse «{ program_read }».
troubles_symptoms_wrongValues_steps_3 = ¿Bajan los tiempos de fila en fila? Entonces la página pregunta cómo leerlos.
troubles_symptoms_wrongValues_steps_4 = En F1B y F1E, compare los tiempos con el programador portátil.
troubles_symptoms_cutOff_title = La escritura se ha interrumpido
troubles_symptoms_cutOff_steps_1 = No vuele aún este modelo. Conecte el temporizador: la página lo lee, y después ofrece terminar la escritura o escribir los valores de antes.
troubles_symptoms_cutOff_steps_2 = Lo que el temporizador contenía antes está en la vista «{ views_names_memories }», «{ backups_title }».
troubles_symptoms_noDt_title = El DT no llega, o llega a destiempo
troubles_symptoms_noDt_steps_1 = Mire en la parte de arriba de la página: se ve con qué memoria será el próximo vuelo, y su DT. Otra memoria tiene otro DT.
troubles_symptoms_noDt_steps_2 = ¿El interruptor de lanzamiento vuelve cada vez a su sitio? Mientras está pulsado, la secuencia no empieza y el DT no llega.
troubles_symptoms_noDt_steps_3 = ¿La batería está cargada, y su conector metido hasta el fondo? Si el temporizador no está en marcha, el DT no llega.
troubles_symptoms_noDt_steps_4 = Sujete bien el modelo y pulse la fila DT en la vista «{ views_names_bench }». ¿El servo va a la posición de DT, y suelta lo que retiene?
troubles_symptoms_noDt_steps_5 = Quite la hélice y deje que el temporizador llegue hasta el final. No vuele antes de haber visto el servo moverse cuando llega el tiempo de DT.
troubles_symptoms_noMove_title = Un servo no se mueve
troubles_symptoms_noMove_steps_1 = Sujete el modelo y pulse en la vista «{ views_names_bench }» la fila de la función en la que el servo debe moverse. ¿No se mueve nada? Revise conector y batería. ¿Se mueve allí, pero no en vuelo? Entonces tiene la misma posición que en la función anterior.
troubles_symptoms_noMove_steps_2 = ¿Va a un sitio distinto del que dice la tabla? Puede que algunos temporizadores almacenen una posición solo para la función en la que están los servos. Entonces la página ofrece mover los servos mientras escribe.
troubles_symptoms_noMove_steps_3 = ¿Zumba, o se para demasiado pronto? Puede que el varillaje lo bloquee: pruebe un movimiento más pequeño.
troubles_symptoms_noMotor_title = El motor no arranca
troubles_symptoms_noMotor_steps_1 = Después de un vuelo, el temporizador bloquea el motor. Para liberarlo, sujete el modelo y mantenga las manos lejos de la hélice: puede arrancar. Después mantenga pulsado el botón «{ bench_unlock }» en la vista «{ views_names_bench }».
troubles_symptoms_noMotor_steps_2 = ¿El interruptor de lanzamiento ha vuelto a su sitio? Mientras está pulsado, el motor solo gira al ralentí.
troubles_symptoms_noMotor_steps_3 = ¿El paro de motor está puesto lo bastante tarde? Con 0,1 s, el motor se para nada más arrancar.
troubles_symptoms_noLibrary_title = Mis modelos y programas no están aquí
troubles_symptoms_noLibrary_steps_1 = Vacíe el campo de búsqueda, pulse Archivo.
troubles_symptoms_noLibrary_steps_2 = Cada navegador, perfil y dirección tiene su propia biblioteca; una ventana privada la borra.
troubles_symptoms_noLibrary_steps_3 = En otro dispositivo, o si se ha perdido: Importar, y el archivo de su última exportación.

## What to do, step by step, when a timer cannot be reached.

help_title = Qué hacer
help_steps_programs = Cierre otras pestañas y programas que usen el adaptador, como Arduino IDE, PuTTY, un programa de impresora 3D o un configurador de drones.
help_steps_replug = Desenchufe el adaptador, espere cinco segundos, enchúfelo de nuevo. Si no sirve, reinicie el ordenador.
help_steps_cable = Enchufe el adaptador directamente, sin hub, y pruebe otro cable. Muchos cables USB solo cargan.
help_steps_windows = Windows: abra el Administrador de dispositivos. Una señal amarilla en el adaptador significa que falta su controlador: conéctese a Internet y ejecute Windows Update.
help_steps_mac = Mac: permita el accesorio cuando el Mac lo pregunte. Un macOS antiguo necesita el controlador del fabricante.
help_steps_linux = Puede que Linux no le deje usar el adaptador. Ejecute esto, cierre la sesión y vuelva a entrar.
help_steps_linux-container = Puede que el Linux de un Chromebook haya tomado el adaptador. Desactive el adaptador en Configuración, en Entorno de desarrollo de Linux, Gestionar dispositivos USB.
help_steps_android = En Android, use { android }. { restWorks }
help_steps_bluetooth = Bluetooth: empareje el adaptador en los ajustes del sistema (código 1234 o 0000), manténgalo encendido y cerca, y desactive el Bluetooth de otros dispositivos que lo usen.
help_steps_firefox-finds = Firefox no encuentra adaptadores Bluetooth, y ninguno si procede de la tienda de Ubuntu. Use Chrome.
help_steps_firefox-reload = Firefox retiene un adaptador que ha fallado. Vuelva a cargar esta página. Lo que ha introducido se conserva.
help_steps_switch = { link_stages_steps_switch }
help_steps_near = { link_stages_steps_near }
help_steps_battery = ¿La batería del temporizador está cargada y conectada? Con la batería vacía, un temporizador queda en su posición de DT.
help_steps_restarts = Algunos adaptadores se reinician cada vez que se abre su puerto (DTR los reinicia), y durante unos segundos no oyen nada. Si el suyo lo hace, fije su velocidad en Ajustes, «{ ports_settings }»: así el puerto se abre una sola vez. La página misma deja DTR como lo pone el navegador.
help_steps_usual-settings = Abra Ajustes, «{ ports_settings }», y pulse «{ ports_reset }»: así la página encuentra la velocidad por sí sola.
help_steps_report = Si vuelve a ocurrir: Ajustes, Experto, Línea, «{ line_copyReport }». Envíelo a:
help_steps_address = Abra esta dirección en una pestaña:
help_page = Todos los pasos, para cada sistema

## For when the browser does not store, or give back, what it should.

keeping_title = Este navegador no lo conserva todo.
keeping_notKept = Lo que introduce, las copias de seguridad y la nota de una escritura interrumpida duran solo mientras esta página está abierta. Exporte la biblioteca. Después cierre otras pestañas de esta página, o haga sitio en este dispositivo.
keeping_notKnown = El navegador no dice si conserva lo que usted hace. Delo por no conservado, y exporte la biblioteca.
keeping_oneTab = Use una sola pestaña de esta página.
keeping_emptied = El navegador ha borrado lo que conservaba para esta página. Exporte lo que aún ve.
keeping_export = Exportar la biblioteca…

## Stored data that cannot be read.

aside_title =
    { $count ->
        [one] No se ha podido leer { $count } registro. Se ha apartado, no borrado.
       *[other] No se han podido leer { $count } registros. Se han apartado, no borrado.
    }
aside_write = Está incluida la nota de una escritura interrumpida: lea el temporizador antes de volar.
aside_save = Guardar en un archivo

## “2 models, 1 program”: only kinds that there are.

counted_models =
    { $count ->
        [one] { $count }{"\u00a0"}modelo
       *[other] { $count }{"\u00a0"}modelos
    }
counted_settings =
    { $count ->
        [one] { $count }{"\u00a0"}programa
       *[other] { $count }{"\u00a0"}programas
    }
counted_flights =
    { $count ->
        [one] { $count }{"\u00a0"}vuelo
       *[other] { $count }{"\u00a0"}vuelos
    }
counted_backups =
    { $count ->
        [one] { $count }{"\u00a0"}copia
       *[other] { $count }{"\u00a0"}copias
    }

## What was deleted a moment ago.

removed = Borrado: { $what }.

## Deletes everything that this device keeps.

erase_open = Borrar todo en este dispositivo…
erase_lead = Esto borra de este navegador todos los modelos, programas, vuelos, copias de seguridad, cambios sin escribir y elecciones de esta página. No se puede deshacer. Los temporizadores mantienen lo que contienen.
erase_uncertain = Se interrumpió una escritura, y no se sabe qué contiene ese temporizador. Sin la nota de esa escritura, esta página no puede avisarle: lea ese temporizador antes de volar.
erase_start = Borrar todo
erase_running = Borrando
erase_failed = No se ha podido borrar todo. Cierre otras pestañas de esta página e inténtelo de nuevo, o borre sus datos en los ajustes del navegador.

## For a page that is shown inside another page.

framed_title = Sidus Timer solo funciona en su propia pestaña: otra página podría tapar lo que usted ve de su temporizador.
framed_open = Abrir Sidus Timer en su propia pestaña

## What is known about the content of a timer, and what is not.

knowledge_title = Incierto
knowledge_uncertain = No se sabe qué contiene { $memory }: { $values }.
knowledge_noFly = No vuele antes de leerla.
knowledge_since = Escritura interrumpida (inicio: { $time }).
knowledge_thisMemory = la memoria actual
knowledge_memoryOf = { $memory } ({ $timer })
knowledge_timer_here = { $name } { $firmware }
knowledge_timer_simulated = { $name } { $firmware } simulado
knowledge_otherTimer_here = otro { $name } { $firmware }
knowledge_otherTimer_simulated = otro { $name } { $firmware } simulado
knowledge_motorStop = paro de motor
knowledge_either = { $name } es { $before } o { $goal }
knowledge_list =
    { $more ->
        [one] { $named }, y { $more }{"\u00a0"}valor más es incierto
       *[other] { $named }, y { $more }{"\u00a0"}valores más son inciertos
    }
knowledge_and = { $first } y { $next }
knowledge_connect = Conectar y leer
knowledge_forget = Olvidar esto…
knowledge_forgetSure = Olvídelo solo si ha leído ese temporizador en otro sitio, o ya no lo tiene.
knowledge_forgetNow = Olvidarlo ahora
knowledge_verified = Como en el temporizador, verificado { $time }
knowledge_readAt = Como en el temporizador, leído { $time }
knowledge_lastReadAt = Como en la última lectura, { $time }
knowledge_lastRead = Como en la última lectura
knowledge_ofSetting =
    { $changes ->
        [0] { $name }: guardado
        [one] { $name }: { $changes } cambio sin guardar
       *[other] { $name }: { $changes } cambios sin guardar
    }
knowledge_changed = { $name }, cambiado
knowledge_ofModel = { $name } de { $model }
knowledge_made = Programa nuevo, aún no está en un temporizador
knowledge_unknown = No se sabe qué contiene { $memory }
knowledge_unfinished =
    { $count ->
        [one] { $count } campo aún no tiene valor
       *[other] { $count } campos aún no tienen valor
    }
knowledge_hints_now = Los campos marcados difieren de lo que contiene el temporizador.
knowledge_hints_onceAt = Los campos marcados difieren de la última lectura, { $time }.
knowledge_hints_once = Los campos marcados difieren de la última lectura.
knowledge_marks_now = era { $value }
knowledge_marks_once = última lectura { $value }
knowledge_notCertain = , ahora incierto
knowledge_held_now = En el temporizador
knowledge_held_once = Última lectura

## Why a program of the library or from a link cannot be opened now.

obstacles_busy = Esta página está leyendo, escribiendo o buscando un temporizador. Espere a que termine.
obstacles_following = Los servos siguen las posiciones. Detenga eso primero.
obstacles_not-fitting = { notFitting }

## Models and their saved programs.

library_unread = El navegador no puede leer ahora la biblioteca. Cierre otras pestañas de esta página e inténtelo de nuevo.
library_empty_title = Aún no hay modelos
library_empty_lead = Un modelo contiene sus programas, con nombres y notas. Solo se conservan en este dispositivo.
library_empty_hint = Cree un modelo, o lea un temporizador y guarde su programa.
library_search_label = Buscar programas
library_search_nothing = Ningún programa tiene todas estas palabras.
library_models_title = Modelos
library_models_all = Todos los modelos
library_models_make = Nuevo modelo…
library_models_settings =
    { $count ->
        [one] { $count } programa
       *[other] { $count } programas
    }
library_models_archive = Archivo ({ $count })
library_models_archived = archivado
library_models_latest = Últimos cambios
library_list_open = en la pantalla
library_model_timerClass = Clase
library_model_noClass = No indicada
library_model_facts = Sobre este modelo
library_model_noSettings = Aún no hay programas.
library_model_servos = Servos
library_model_servosUnknown = Guarde primero un programa de este modelo.
library_model_servoWay = de { $low } a { $high } pasos
library_model_archive = Archivar
library_model_unarchive = Sacar del archivo
library_model_remove = Borrar el modelo
library_model_withSettings =
    { $count ->
        [one] Se borra también su programa. Deshacer los recupera.
       *[other] Se borran también sus { $count }{"\u00a0"}programas. Deshacer lo recupera todo.
    }
library_setting_isOpen = En la pantalla: verlo
library_setting_loadAgain =
    { $count ->
        [one] Volver a abrir: { $count } valor vuelve atrás
       *[other] Volver a abrir: { $count } valores vuelven atrás
    }
library_setting_tags = Etiquetas, separadas por comas
library_setting_from_typed = introducido
library_setting_from_timer = leído de un temporizador
library_setting_from_simulated = leído de un temporizador simulado
library_setting_from_backup = de una copia de seguridad
library_setting_from_file = de un archivo
library_setting_from_link = de un enlace
library_setting_origin = { $source }, { $time }
library_setting_notShown = No se ha podido abrir. Inténtelo de nuevo.
library_setting_gone = Ya no está en la biblioteca.
library_save_open = Guardar…
library_save_over = Guardar sobre { $program }
library_save_undo = Deshacer el guardado de { $name }
library_save_crossing = Estos son valores de { $from }. Guardarlos en { $to }.
library_save_asNew = Guardar como nuevo…
library_save_taken = Ya hay un programa { $program }. Introduzca otro nombre, o bien:
library_save_replace = Guardar encima. Sus valores se quedan como versión anterior.
library_save_name =
    { $of ->
        [program] Nombre del programa
       *[model] Nombre del modelo
    }
library_save_namePlace = Por ejemplo: fly-off, calma
library_save_notSavable = Un campo no tiene valor. Corríjalo primero.
library_save_state =
    { $changes ->
        [0] { $name }: guardado
        [one] { $name }: { $changes } cambio sin guardar
       *[other] { $name }: { $changes } cambios sin guardar
    }
library_nameNeeded = Necesita un nombre.

## The log of the line.

line_empty = Nada que mostrar.
line_unused = Aún no hay nada en la línea. También puede cargar una grabación y reproducirla como temporizador.
line_all = Todo
line_out = Al temporizador
line_in = Del temporizador
line_damaged = Dañado
line_request = { $name } · { $letters }
line_reply = { $name }, respuesta · { $letters }
line_echo = { $name }, eco · { $letters }
line_unknown = Letra desconocida { $letter }
line_names_GETTIMERS = Leer tiempos
line_names_SETTIMERS = Escribir tiempos
line_names_GETSERVOPOS = Leer posiciones
line_names_SETSERVO = Escribir una posición
line_names_MOVETOFUNC = Mover servos
line_names_GETSWVER = Identificar
line_names_UNLOCK = Desbloquear motor
line_names_JUMP2 = Saltar
line_names_GETMEMORY = Qué memoria
line_names_SETMEMORY = Seleccionar memoria
line_names_GETLOWRPM = Leer ralentí
line_names_SETLOWRPM = Escribir ralentí
line_rejected_noise = Dañado: ruido
line_rejected_length = Dañado: longitud imposible
line_rejected_terminator = Dañado: sin final donde debería estar
line_rejected_checksum = Dañado: suma de control incorrecta
line_rejected_silence = Dañado: cortado
line_error_framing = Error de línea: framing
line_error_parity = Error de línea: paridad
line_error_break = Error de línea: break
line_error_overrun = Error de línea: desbordamiento, se han perdido bytes
line_error_other = Error de línea de otro tipo
line_position = { $slot }, { $servo }: { $steps } pasos
line_motorStop = paro de motor { $time }
line_reserved = reservado { $time }
line_functions = funciones { $times }
line_identity = { $name }, firmware { $firmware }, { $functions } y DT, { $memories }, { $servos }
line_memories =
    { $count ->
        [one] { $count } memoria
       *[other] { $count } memorias
    }
line_memoryUnsaid = No dice cuál.
line_idleThrottle = { $value }, unidad desconocida
line_idleThrottleUnsaid = No da ningún valor.
line_acknowledged = Confirmado.
line_unreadable_wrong-length = Su contenido es más largo o más corto de lo debido.
line_unreadable_unknown-command = No se sabe qué significa.
line_unreadable_unexpected-reply = Responde a otra petición.
line_unreadable_bad-identity = Lo que dice del temporizador no puede ser correcto.
line_unreadable_identity-needed = Se puede leer cuando el temporizador ha dicho qué es.
line_unreadable_out-of-range = Un valor que contiene no puede ser correcto.
line_unreadable_not-an-integer = { line_unreadable_out-of-range }
line_unreadable_wrong-count = { line_unreadable_out-of-range }
line_unreadable_wrong-type = { line_unreadable_out-of-range }
line_unreadable_unknown-word = Su contenido no se puede leer.
line_unreadable_bad-capture = { line_unreadable_unknown-word }
line_unreadable_bad-file = { line_unreadable_unknown-word }
line_unreadable_bad-link = { line_unreadable_unknown-word }
line_unreadable_newer-version = { line_unreadable_unknown-word }
line_unreadable_too-large = { line_unreadable_unknown-word }
line_unreadable_duplicate = { line_unreadable_unknown-word }
line_goOn = Seguir
line_came =
    { $number ->
        [one] En pausa. { $number } entrada desde entonces.
       *[other] En pausa. { $number } entradas desde entonces.
    }
line_clear = Vaciar
line_unidentified = desconocido
line_load = Cargar…
line_filter = Mostrar
line_searchHint = nombre o hex
line_counts_out = { $count } al temporizador
line_counts_in = { $count } del temporizador
line_counts_damaged =
    { $count ->
        [one] { $count } dañado
       *[other] { $count } dañados
    }
line_counts_errors =
    { $count ->
        [one] { $count } error de línea
       *[other] { $count } errores de línea
    }
line_recording =
    { $entries ->
        [one] { $name }: una grabación de { $entries } entrada.
       *[other] { $name }: una grabación de { $entries } entradas.
    }
line_replay = Reproducir como temporizador
line_cannotReplay = No se puede reproducir: el temporizador nunca dice qué es.
line_back = Volver a la línea en directo
line_noRecordingAt = Línea { $line }: se esperaba un tiempo en segundos, > o <, y bytes en hex.
line_noRecording = Este archivo no es una grabación.
line_send_title = Enviar una trama a mano
line_send_lead = La página añade longitud y suma de control.
line_send_bytes = Letra y datos, en hex
line_send_faults_hex = Introduzca dos cifras hex por cada byte, de 0 a 9 o de A a F.
line_send_faults_too-long = Una trama lleva como máximo 252 bytes.
line_send_preview = Sale como
line_send_send = Enviar…
line_send_confirmTitle = ¿Enviar esta trama al temporizador?
line_send_danger = Los servos pueden moverse, la hélice puede arrancar, y lo que contiene el temporizador puede cambiar. Después se lee de nuevo el temporizador.
line_send_confirm = Sí, enviar una vez
line_send_sending = Enviando
line_send_answered = Respuesta:
line_send_unanswered = No ha llegado respuesta. Aun así, lo que pedía la trama puede haber ocurrido.
line_copyReport = Copiar informe

## From the ports to a timer that answers.

link_portNames_ftdi = Adaptador FTDI
link_portNames_cp210x = Adaptador CP210x (Silicon Labs)
link_portNames_ch340 = Adaptador CH340 (WCH)
link_portNames_pl2303 = Adaptador PL2303 (Prolific)
link_portNames_bluetooth = Bluetooth
link_portNames_usb = Adaptador USB
link_portNames_other = Puerto serie
link_stages_choosing = Elija el adaptador del temporizador
link_stages_openingLong_title = El adaptador tarda en abrirse
link_stages_openingLong_advice = Bluetooth: encienda el adaptador y acérquelo. Cable: desenchúfelo y enchúfelo de nuevo.
link_stages_asking = Preguntando a { $rate } baudios.
link_stages_noAnswer = Sin respuesta desde hace { $seconds } s. Esta página sigue preguntando y continúa por sí sola.
link_stages_open = El adaptador está abierto
link_stages_steps_switch = Despierte el temporizador: pulse brevemente su interruptor
link_stages_steps_near = Ponga el cabezal de infrarrojos a menos de 20 cm, fuera del sol
link_stages_steps_other = ¿Está el temporizador en otro adaptador?
link_refused = La página lo intenta durante 15 segundos. Puede que otro programa tenga el adaptador.
link_heard_title = Se oye algo, pero ningún temporizador responde.
link_heard_advice = Despierte el temporizador y acerque más el cabezal, fuera del sol, o elija otro adaptador.
link_slow_title = Un temporizador responde, pero demasiado despacio.
link_slow_advice = Sus bytes llegan uno a uno a { $rate } baudios, con huecos tan largos que ninguna respuesta está completa a tiempo. Esta página no puede leerlo. Pruebe otro adaptador, o un cable en lugar de Bluetooth.
link_itSaid = Ha llegado: { $bytes } («{ $text }»).
link_trySelectBare = Probar sin una suma de control correcta
link_lost_title = Se ha perdido la conexión con el adaptador.
link_lost_advice = Enchúfelo, o acérquelo: la página continúa por sí sola. Lo que ha introducido se conserva.
link_status_off = Sin conexión
link_status_opening = Conectando
link_status_searching = Buscando el temporizador
link_status_away = Conexión perdida
link_status_closing = Desconectando

## The known ports, and how they are opened.

ports_title = Adaptadores conocidos
ports_forget = Olvidar
ports_settings = Ajustes del puerto
ports_settingsHint = Solo para un adaptador especial. La página encuentra la velocidad por sí sola.
ports_rate = Velocidad
ports_findRate = Automática
ports_baud = { $rate } baudios
ports_parity = Paridad
ports_parities_none = Ninguna
ports_parities_even = Par
ports_parities_odd = Impar
ports_stopBits = Bits de parada
ports_dtr = DTR
ports_rts = RTS
ports_signals_leave = Como la pone el navegador
ports_signals_on = Activa
ports_signals_off = Inactiva
ports_reset = Ajustes habituales

## What is known about the connected timer. Its numbers are in the report.

aboutTimer_title = Este temporizador
aboutTimer_damage = Daños vistos en la línea
aboutTimer_crowd = Puede haber otro temporizador o programador en el haz. Desde entonces, dos lecturas deben coincidir.
aboutTimer_found = Qué ha hecho de otra manera
aboutTimer_nothingFound = Nada hasta ahora: ha hecho todo lo que se le pidió de la manera habitual.
aboutTimer_quirkNames_timers-reply-66 = Responde con la letra de otra orden.
aboutTimer_quirkNames_unlock-reply-6a = { aboutTimer_quirkNames_timers-reply-66 }
aboutTimer_quirkNames_memory-unknown = No dice qué memoria es la actual.
aboutTimer_quirkNames_memory-impossible = { aboutTimer_quirkNames_memory-unknown }
aboutTimer_quirkNames_bare-checksum = Sobre el ralentí no responde como es habitual.
aboutTimer_quirkNames_times-big-endian = Sus tiempos bajan. Con los dos bytes de cada uno intercambiados subirían.
aboutTimer_quirkNames_servo-first = Al escribir una posición, toma el servo antes que la función.
aboutTimer_quirkNames_servo-unanswered = No respondió cuando se escribió una posición.
aboutTimer_quirkNames_times-rounded = Redondea los tiempos.
aboutTimer_quirkNames_memories-from-one = Cuenta sus memorias desde 1.
aboutTimer_quirkNames_positions-unchanged = Confirmó posiciones, pero no las mantuvo.
aboutTimer_quirkNames_echo = El adaptador devuelve lo que se le envía.
aboutTimer_quirkNames_idle-throttle-unanswered = { aboutTimer_quirkNames_bare-checksum }
aboutTimer_quirkNames_identity-unusual = Lo que dice de sí mismo tiene bytes que no se conocen.
aboutTimer_quirkNames_idle-throttle-malformed = { aboutTimer_quirkNames_bare-checksum }
aboutTimer_quirkNames_replies-alike = Sus respuestas a algunas peticiones están dañadas, cada una de la misma manera.
aboutTimer_assumed = Diferencias conocidas
aboutTimer_assumedHint = Se recuerdan para este adaptador y este tipo de temporizador.
aboutTimer_forget = Olvidar las diferencias conocidas
aboutTimer_assumptions_bigEndianTimes = Los dos bytes de cada tiempo están intercambiados
aboutTimer_assumptions_servoFirst = { aboutTimer_quirkNames_servo-first }
aboutTimer_assumptions_memoriesFromOne = { aboutTimer_quirkNames_memories-from-one }
aboutTimer_assumptions_bareChecksumRequests = «Seleccionar memoria» y «escribir ralentí» se envían sin una suma de control correcta
aboutTimer_assumptions_positionsNeedMove = Las posiciones solo se mantienen para la función en la que están los servos

## Which memory flies next, and what is known about the others.

nextFlight_badge = próximo vuelo
nextFlight_onScreen = Esta es { $memory }.
nextFlight_named = { $memory }, próximo vuelo
nextFlight_other = Próximo vuelo con { $memory }.
nextFlight_last = { $memory } era la memoria actual cuando el temporizador respondió por última vez. Será la del próximo vuelo si entretanto no se ha seleccionado otra.
nextFlight_original = Al conectar era { $original }.
nextFlight_originalUnknown = No se sabe cuál era al conectar.
nextFlight_unknown = No se sabe con qué memoria será el próximo vuelo.
nextFlight_asked = La última seleccionada es { $memory }.
nextFlight_back = Volver a { $original }
nextFlight_leaving_title = Antes de desconectar
nextFlight_leaving_back = Volver a { $original } y desconectar
nextFlight_leaving_failed = El temporizador no ha vuelto a { $original }. Sigue conectado.

## The last reading of a memory that is not current.

look_read = { $memory }, leída { $time }
look_notRead = { $memory } no se ha leído
look_either = Puede ser
look_or = o bien
look_lead = Solo para mirar. Próximo vuelo con { $current }.
look_edit = Editar { $memory }
look_look = Mirar { $memory }
look_hint = Esto selecciona { $memory }, la lee y vuelve a { $current }.
look_fly = Elegir { $memory } para el vuelo
look_show = Mostrar { $memory }

## Jobs over several memories, and the backups.

memories_copy = Copiar { $from } a { $to }
memories_restore = Restaurar una copia de seguridad
memories_restoreAll = Restaurar las { $count }…
memories_plans_screen =
    { $keepsThrottle ->
        [true] { $to } contendrá los tiempos y posiciones de la pantalla. Antes se hace una copia de seguridad de lo que { $to } contiene ahora. El ralentí se queda como está.
       *[false] { $to } contendrá los tiempos y posiciones de la pantalla. Antes se hace una copia de seguridad de lo que { $to } contiene ahora.
    }
memories_plans_copy = { $to } contendrá los tiempos y posiciones de { $from }, recién leídos. Antes se hace una copia de seguridad de lo que { $to } contiene ahora.
memories_plans_restore = Esto escribe en { $names } la copia de seguridad ({ $time }). Antes se hace otra de lo que hay ahora.
memories_atEnd = Al final, el próximo vuelo será de nuevo con { $current }.
memories_refused = { $memory }: no se puede escribir nada, porque ningún software puede enviar estos valores.
memories_untouched = No se ha escrito nada en { $memory }.
memories_stopped = Lo que aún no se había escrito está como estaba.

## All memories of a timer at a glance.

overview_readAll = Leer y conservar todas
overview_copyTo = Copiar a…
overview_compareWith = Comparar con { $memory }
overview_readAt = leída { $time }
overview_notCertain = Incierta: se interrumpió una escritura en ella. Se muestra como era antes de esa escritura.
overview_edited = Se muestra y se copia como la contiene el temporizador, sin los cambios hechos aquí.
overview_same = Contienen lo mismo.
overview_differs =
    { $count ->
        [one] { $count } valor difiere.
       *[other] { $count } valores difieren.
    }

## How the timer writes its times: the question that no reading can answer.

byteOrder_title = Los tiempos de este temporizador bajan de fila en fila.
byteOrder_advice = Subirían si se intercambiaran los dos bytes de cada tiempo. Compare con lo que sabe del temporizador, y elija antes de escribir.
byteOrder_keep = Son correctos como se muestran
byteOrder_exchange = Intercambiarlos y leer de nuevo

## Why there is no connection.

connection_unsupported_title = { unsupportedHere_title }
connection_unsupported_advice = { unsupportedHere_advice }
connection_insecure_title = El navegador no permite aquí los puertos serie.
connection_insecure_advice = { restWorks }
connection_policy_title = El servidor de esta página prohíbe los puertos serie.
connection_policy_advice = { restWorks }
connection_nothing-chosen_title = No se ha elegido ningún adaptador.
connection_nothing-chosen_advice = Pulse Conectar y elija el adaptador. Si no está en la lista, ayudan los pasos de abajo.
connection_not-allowed_title = { connection_insecure_title }
connection_not-allowed_advice = Permita los puertos serie para esta página en los ajustes del navegador, y pulse Conectar de nuevo.
connection_busy_title = El adaptador no se abre.
connection_busy_advice = Casi siempre lo tiene otro programa u otra pestaña. Ciérrelo, y pulse Conectar de nuevo.
connection_bad-settings_title = El adaptador no acepta estos ajustes.
connection_bad-settings_advice = { help_steps_usual-settings }
connection_unplugged_title = No se puede acceder al adaptador.
connection_unplugged_advice = Desenchúfelo, enchúfelo de nuevo y pulse Conectar. Lo que ha introducido se conserva.
connection_bad-reply_title = { link_heard_title }
connection_bad-reply_advice = { link_heard_advice }
connection_lost_title = { connection_unplugged_title }
connection_lost_advice = { connection_unplugged_advice }

## Why a job with the timer has ended.

timer_no-answer_title = El temporizador no ha respondido.
timer_no-answer_advice = Pulse brevemente el interruptor del temporizador, ponga el cabezal a menos de 20 cm e inténtelo de nuevo. Lo que ha introducido se conserva.
timer_bad-reply_title = La respuesta del temporizador no puede ser correcta.
timer_bad-reply_advice = Inténtelo de nuevo. Si vuelve a ocurrir: Ajustes, Experto, Línea, «{ line_copyReport }».
timer_unstable_title = La línea tiene demasiado ruido para fiarse.
timer_unstable_advice = Acerque más el cabezal de infrarrojos, fuera del sol, e inténtelo de nuevo.
timer_crowded_title = Puede haber más de un temporizador en el haz.
timer_crowded_advice = Mantenga lejos otros temporizadores y programadores, y lea de nuevo.
timer_other-memory_title = La memoria actual no es la de la pantalla.
timer_other-memory_advice = Lea de nuevo antes de escribir.
timer_memory-unknown_title = Este temporizador no dice qué memoria es la actual.
timer_memory-unknown_advice = Por eso esta página no puede mirar otra memoria y volver. Se puede leer y escribir la actual.
timer_memory-left_title = Puede que la memoria del próximo vuelo ya no sea la misma.
timer_memory-left_advice = Esta página no ha podido volver a la que era la actual. Conecte de nuevo y elija la memoria correcta para el próximo vuelo antes de volar.
timer_other-timer_title = Este no es el temporizador que respondió antes.
timer_other-timer_advice = La página lo lee. Mire qué contiene antes de escribir.
timer_stale_title = El temporizador no contiene lo que se mostraba.
timer_stale_advice = No se ha escrito nada. Mire qué cambiaría ahora una escritura.
timer_changed_title = El temporizador contiene valores distintos de los de antes.
timer_changed_advice = Otra cosa lo ha cambiado, o este es otro temporizador. Los cambios hechos aquí se conservan: mire las diferencias antes de escribir.
timer_stood-still_title = Esta página se quedó parada durante el trabajo.
timer_stood-still_advice = No se ha enviado nada más: ahora puede haber otro temporizador. Lea de nuevo.
timer_too-slow_title = Este temporizador responde demasiado despacio.
timer_too-slow_advice = Sus respuestas tardan más de 3 segundos, así que esta página no puede distinguir a qué pregunta corresponde cada una. No se ha enviado nada más. Pruebe otro adaptador, o un cable en lugar de Bluetooth.
timer_undecided_title = { byteOrder_title }
timer_undecided_advice = { byteOrder_advice }
timer_serious_title = La revisión ha encontrado algo grave.
timer_serious_advice = { timer_stale_advice }
timer_busy_title = Algo en esta página o en este ordenador usa el adaptador.
timer_busy_advice = No se ha enviado nada. Desconecte y conecte de nuevo. Lo que ha introducido se conserva.
timer_port-lost_title = { link_lost_title }
timer_port-lost_advice = { link_lost_advice }
timer_aborted_title = Detenido.
timer_aborted_advice = Lea de nuevo para ver qué contiene el temporizador.
timer_closed_title = Desconectado.
timer_closed_advice = Pulse Conectar para seguir. Lo que ha introducido se conserva.

## Replies that are no noise, which is random.

alike_title = Cada respuesta a { $request } está dañada de la misma manera.
alike_advice = Eso no es ruido: el temporizador o su adaptador forma estas respuestas de una manera que no se conoce. Con Experto activado en los ajustes, abra Línea y pulse «{ line_copyReport }». Envíe el informe a los responsables del proyecto (github.com/sidus-timer/sidus-timer/issues).
alike_part = Solo para mirar: { $values }. Todo lo demás no se conoce.

## Messages that are not about errors.

notes_back_title = Sus cambios están de nuevo aquí.
notes_back_advice = Compárelos con lo que contiene el temporizador, y después escríbalos o deshágalos.
notes_back-uncertain_title = { notes_back_title }
notes_back-uncertain_advice = No se sabe si se han escrito. Conecte el temporizador y léalo antes de volar.
notes_moved_title = { timer_changed_title }
notes_moved_advice = { timer_changed_advice }
notes_timer-moved_title = { timer_changed_title }
notes_timer-moved_advice = { timer_changed_advice }
notes_kept_title = Sus cambios se conservan en este dispositivo.
notes_kept_advice = No encajan con lo que se ha leído ahora. Vuelven cuando lea de nuevo esa memoria; la página inicial también los muestra.
notes_other-kind_title = Ahora hay otro tipo de temporizador.
notes_other-kind_advice = { timer_other-timer_advice }
notes_write-completed_title = La escritura interrumpida está completa.
notes_write-completed_advice = El temporizador se ha leído de nuevo y contiene todo lo que había que escribir.
notes_nothing-written_title = { write_refused }
notes_nothing-written_advice = {""}
notes_not-backed-up_title = { write_unkept_title }
notes_not-backed-up_advice = { keeping_notKept }
notes_select-unanswered_title = El temporizador no respondió al seleccionar una memoria.
notes_select-unanswered_advice = Responde a otras peticiones. Inténtelo de nuevo, o envíe la petición sin una suma de control correcta.
notes_backed-up_title = Se han leído todas las memorias, y se conserva una copia de seguridad de cada una.
notes_backed-up_advice = {""}
notes_strays_title = { timer_crowded_title }
notes_strays_advice = { timer_crowded_advice }
notes_made-laid_title = La tabla muestra el programa abierto aquí, no lo que contiene el temporizador.
notes_made-laid_advice = No se ha escrito nada. Lo que difiere está marcado. «{ undo }» muestra lo que contiene el temporizador.
notes_unexpected_title = Algo ha ido mal en esta página.
notes_unexpected_advice = No se ha enviado nada más. Vuelva a cargar la página. Lo que ha introducido se conserva.

## The flight of the program, and what the servos of the model move.

preview_title = Vista previa del vuelo
preview_guessed = No está a escala.
preview_nameServos = Nombrar los servos…
preview_play = Reproducir
preview_speed = Velocidad
preview_time = Tiempo del vuelo
preview_launch = Lanzamiento
preview_at = { $what } a { $time }
preview_sketch = El modelo de lado, y su timón desde arriba
preview_motor_true = Trepada, motor en marcha
preview_motor_false = Planeo, motor parado
preview_flies = En vuelo
preview_comesDown = DT: el modelo baja
preview_duties_rudder = Timón
preview_duties_tailplane = Estabilizador
preview_duties_wing = Ala
preview_duties_release = Disco o hilo del DT
preview_duties_other = Otra cosa
preview_duties_none = Sin uso
preview_naming_lead = Qué mueve cada servo, y entre qué pasos. Arriba y abajo se refieren al borde de salida.
preview_naming_duty = { $servo } mueve
preview_naming_name = Nombre de lo que mueve { $servo }
preview_naming_low = { $servo }, un extremo en pasos
preview_naming_high = { $servo }, el otro extremo en pasos
preview_naming_from = de
preview_naming_to = a
preview_naming_sense = { $servo }, efecto de más pasos
preview_naming_otherSense_false = más pasos: arriba
preview_naming_otherSense_true = más pasos: abajo
preview_naming_rudderSense_false = más pasos: derecha
preview_naming_rudderSense_true = más pasos: izquierda

## The sheet of a program.

print_paper = Papel
print_what = En la hoja
print_parts_lines = Líneas para escribir
print_parts_code = Código QR
print_nothing = Elija programas de la biblioteca, o abra uno.
print_choose = Programas de esta impresión: { $chosen }
print_clear = Quitar todos
print_simulated = temporizador simulado
print_warnings = Mire esto antes de volar
print_notes = Notas
print_codeHint = La cámara de un teléfono abre este programa, sin su nota.
print_unfinished =
    { $count ->
        [one] { $count } campo aún no tiene valor: se imprime el último
       *[other] { $count } campos aún no tienen valor: se imprime el último
    }
print_printed = Impreso { $date }

## The model in the strip.

recognition_which = ¿Qué modelo?
recognition_change = Modelo { $model }: indicar qué modelo es

## A memory with the pilot's name for it: M2 “fly-off”.

memoryNames_named = { $memory } «{ $name }»

## What an earlier job left behind on a timer.

recovery_title = Se interrumpió una escritura anterior.
recovery_when = Escritura en { $memory }, inicio: { $time }.
recovery_nothing =
    { $missing ->
        [one] El temporizador contiene lo que contenía antes: no se escribió nada, falta { $missing } cambio.
       *[other] El temporizador contiene lo que contenía antes: no se escribió nada, faltan { $missing } cambios.
    }
recovery_part =
    { $missing ->
        [one] De esa escritura, el temporizador contiene { $values }; { $missing } valor sigue como antes.
       *[other] De esa escritura, el temporizador contiene { $values }; { $missing } valores siguen como antes.
    }
recovery_foreign =
    { $count ->
        [one] { $count } valor del temporizador no es ni de antes ni de esa escritura. ¿Es otro temporizador, o lo ha cambiado otra cosa?
       *[other] { $count } valores del temporizador no son ni de antes ni de esa escritura. ¿Es otro temporizador, o los ha cambiado otra cosa?
    }
recovery_sure = Esta página no distingue los temporizadores de un mismo tipo. Siga solo si este es el temporizador de esa escritura.
recovery_finish = Terminar la escritura…
recovery_goBack = Escribir los valores de antes…
recovery_leave = Dejarlo como está
recovery_otherTimer = Es otro temporizador
recovery_sameTimer = Es el mismo temporizador: mostrar qué había que escribir
recovery_compare = Comparar
recovery_before = Antes
recovery_elsewhere = Se interrumpió una escritura en { $memory } de un temporizador de este tipo. Lea { $memory } para ver qué contiene.
recovery_left = Se interrumpió el trabajo con las memorias. Ahora el próximo vuelo es con { $current }. Antes era con { $original }.
recovery_mayFly = Puede que el próximo vuelo sea con { $memory }: se interrumpió su selección.
recovery_mayNotFly = Se interrumpió el trabajo con las memorias. Puede que el próximo vuelo sea con una memoria distinta de { $original }.
recovery_unknownMemory = una memoria desconocida

## The backups.

backups_title = Copias de seguridad
backups_empty = Antes de cada escritura, esta página conserva aquí lo que contiene el temporizador.
backups_reasons_write = antes de escribir
backups_reasons_memories = todas las memorias

## How the page looks.

theme_title = Colores
theme_names_system = Sistema
theme_names_light = Claro
theme_names_dark = Oscuro
theme_names_sun = Sol

## The settings of the page.

settings_look = Aspecto
settings_expert = Experto: mostrar la línea
settings_expertHint = La línea muestra cada byte entre esta página y el temporizador. El banco ofrece un salto que no está documentado.
settings_kept = Qué conserva este dispositivo

## A saved program as a link and a QR code, and back.

share_offer_lead = El enlace contiene el programa entero. No se envía nada a un servidor.
share_offer_link = Enlace
share_offer_copy = Copiar enlace
share_offer_scan = Apunte la cámara del otro dispositivo a este código, o envíe el enlace.
share_offer_qr = Código QR de «{ $name }»
share_offer_cut = El final de la nota no cabe en el código QR. El enlace contiene la nota entera.
share_offer_tooLong = Demasiado largo para un código QR. Envíe el enlace.
share_received_title = Un programa de un enlace
share_received_lead = Por ahora esta página solo lo muestra. No se conserva nada, y no se escribe nada en un temporizador.
share_received_known = La biblioteca ya tiene estos valores: { $name }.
share_received_modelChoice = Conservar en
share_received_newModel = Modelo nuevo «{ $name }»
share_received_keep = Conservar en la biblioteca
share_received_discard = No conservar
share_received_unwritten = Lo que ha introducido se conserva: Deshacer, o la página inicial, lo recupera.
share_damaged_title = Este enlace no se puede leer.
share_damaged_bad = Está cortado o dañado, o no es de esta página. Pídalo de nuevo.
share_paste_title = Pegar un enlace…
share_paste_lead = La cámara de un teléfono abre un código QR por sí sola. Aquí puede pegar un enlace.
share_paste_show = Mostrar
share_paste_notLink = Esto no es un enlace a un programa.

## A DT for trimming that is about to be flown. The page asks before the pilot disconnects, and at a contest round.

shortDt_held = El DT de { $memory } es { $dt }.
shortDt_heldHere = El DT es { $dt }.
shortDt_ask =
    { $remembered ->
        [true] ¿Devolverlo a { $back }?
       *[false] ¿Ponerlo en { $back }?
    }
shortDt_putBack =
    { $remembered ->
        [true] Devolver el DT a { $back }…
       *[false] Poner el DT en { $back }…
    }
shortDt_disconnect = Desconectar así: { $memory }, DT{"\u00a0"}{ $dt }
shortDt_disconnectHere = Desconectar así: DT{"\u00a0"}{ $dt }
shortDt_blocked = Algo que ha introducido aún no se puede escribir. Corríjalo antes de devolver el DT a su valor.
shortDt_settings_limit = Un DT es corto si es menor de
shortDt_settings_hint = Un DT más corto está en rojo, y la página pregunta antes de desconectar. Con el límite a 0 s no pregunta nunca.

## The start, before anything was read.

start_title = Programe su temporizador Sidus
start_lead = Lea lo que contiene, cámbielo, escríbalo y véalo verificado. Nada sale de este dispositivo.
start_adapter = Enchufe el adaptador
start_firefox = Firefox pide primero un permiso, y el puerto cada vez que se carga esta página.
start_android = Un teléfono se conecta por Bluetooth; un cable necesita Android { firstVersions_androidCable } y Chrome { firstVersions_android }.
start_readyOffline = Preparada sin red
start_install = Instalar
start_picture_example = Ejemplo: un F1Q
start_picture_kept = Conservado { $time }
start_models_title = Mis modelos
start_models_none = Conserve los programas de cada modelo, con notas.
start_models_programs =
    { $count ->
        [one] { $count } programa
       *[other] { $count } programas
    }
start_models_library = Abrir la biblioteca
start_programs_title = Sin terminar
start_programs_made = { $timer }, nuevo
start_programs_changesOf = { $timer }, cambios
start_programs_sure = ¿Borrarlo para siempre?
start_simulatedTitle = ¿Sin temporizador a mano?
start_simulatedLead = Uno simulado responde como uno real, byte a byte.
start_simulated = Probar un temporizador { $name } simulado
start_backups =
    { $count ->
        [one] { $count } copia de seguridad, conservada antes de escribir. La última: { $last }.
       *[other] { $count } copias de seguridad, conservadas antes de escribir. La última: { $last }.
    }

## The dialog that makes a program without a timer.

newProgram_title = Programa nuevo…
newProgram_timerClass = Clase
newProgram_functions = Funciones, sin salida ni DT
newProgram_servos = Servos
newProgram_from = Empezar con
newProgram_beginnings_usual = Tiempos habituales, servos en el centro
newProgram_beginnings_nothing = Todos los tiempos y posiciones a 0
newProgram_caution = Aquí no se conocen las posiciones de su modelo. Ponga cada una antes de escribir.
newProgram_make = Crear el programa

## The picture of a program over time.

timeline_title = Diagrama
timeline_compareBefore = antes del seguimiento
timeline_picture = Posiciones de los servos en el tiempo
timeline_description = { $servos } y { $functions } en el tiempo, DT a { $dt }. La tabla tiene todos los valores.
timeline_descriptionMotor = { $servos } y { $functions } en el tiempo, DT a { $dt }, paro de motor a { $motorStop }. La tabla tiene todos los valores.
timeline_functions =
    { $count ->
        [one] { $count } función
       *[other] { $count } funciones
    }
timeline_servos =
    { $count ->
        [one] { $count } servo
       *[other] { $count } servos
    }
timeline_keysToEdit = Las flechas van de marca en marca y de servo en servo, más y menos amplían y reducen, 0 muestra todo. Intro va a los tiradores: las flechas los mueven, Escape vuelve.
timeline_ask = Señale o toque para leer
timeline_finer = Más fino
timeline_steps =
    { $position ->
        [one] { $position } paso
       *[other] { $position } pasos
    }
timeline_stepsUnit = pasos
timeline_notKnown = No se conoce: los tiempos bajan
timeline_tools = Vista
timeline_zoomIn = Ampliar
timeline_zoomOut = Reducir
timeline_fit = Mostrar todo
timeline_passedOver = { $slot }: se salta, porque { $next } llega al mismo tiempo.
timeline_goesBack = { $next } llega antes que { $slot }. No se sabe qué hace el temporizador en la parte sombreada.

## A new version of the page.

update_ready = Hay una versión nueva lista.
update_waits = Empieza cuando usted desconecta y no queda nada abierto o sin guardar.
update_take = Usarla ahora
update_news = Novedades

## The version of this page.

aboutPage_title = Esta página
aboutPage_version = Sidus Timer { $version }.
aboutPage_offline = La página entera está en este dispositivo: funciona sin red.
aboutPage_notOffline = La página aún no se conserva en este dispositivo: ábrala una vez con red.
aboutPage_licences = Licencias

## The views of the page and the links between them.

views_title = Vistas
views_names_program = Programa
views_names_memories = Memorias
views_names_bench = Banco
views_names_library = Biblioteca
views_names_line = Línea
views_names_settings = Ajustes
views_names_print = Imprimir
views_names_help = Ayuda
views_print = Imprimir…
views_share = Compartir…
views_noTimer_memories = Conecte un temporizador para ver sus memorias. Las copias de seguridad están abajo.
views_noTimer_bench = Conecte un temporizador para mover sus servos.

## The strip above every view: the timer, its memory, DT, motor stop, and what is known.

strip_panel = Memorias y más
strip_tried =
    { $count ->
        [one] { $count } probada
       *[other] { $count } probadas
    }
strip_notCertain = incierto
strip_asRead = última lectura
strip_notValid = no válido
strip_ofSetting =
    { $changes ->
        [0] guardado
       *[other] { $changes } sin guardar
    }
strip_made = en ningún temporizador

## The list of commands.

palette_title = Órdenes
palette_search = Introduzca lo que quiere hacer
palette_nothing = Ninguna orden tiene este nombre, o no es posible ahora.
palette_ctrl = Ctrl+{ $key }

## In place of a part of the page that is being loaded.

parts_coming = Cargando
parts_failed = No se ha podido cargar una parte de esta página.
parts_again = Intentar de nuevo

## Which model it is.

whichModel_recognition_same = Este es { $model }, con los valores de la última vez ({ $when }).
whichModel_recognition_like =
    { $count ->
        [one] Se parece a { $model }, { $count } valor difiere. ¿Es { $model }?
       *[other] Se parece a { $model }, { $count } valores difieren. ¿Es { $model }?
    }
whichModel_recognition_several = Puede ser { $models }. ¿Qué modelo es?
whichModel_or = { $names } o { $last }
whichModel_others = { $count } más
whichModel_recognition_unknown = Este temporizador no se conoce aquí. ¿Qué modelo es?
whichModel_recognition_yes = Sí, { $model }
whichModel_recognition_choose = Elegir…
whichModel_recognition_ok = Aceptar
whichModel_recognition_dialog_title = ¿Qué modelo es?
whichModel_recognition_dialog_lead = Un temporizador no conoce su modelo. La página compara lo que contiene con lo último que vio en cada modelo.
whichModel_recognition_dialog_said = Usted ha dicho que es { $model }.
whichModel_recognition_dialog_moreMemories = Lea también las otras memorias: pueden distinguir los modelos.
whichModel_recognition_dialog_none = No hay tal modelo de esta clase.
whichModel_recognition_dialog_newModel = Un modelo nuevo
whichModel_recognition_dialog_keep = Conservar como modelo nuevo
whichModel_memoryNames_label = Nombre de { $memory }
whichModel_memoryNames_give = Nombre
whichModel_crossing_title = Estos son valores de { $from }, pero este temporizador parece el de { $to }.
whichModel_crossing_advice = Con los valores de otro modelo puede perder este. Mire el modelo que tiene delante.
whichModel_crossing_confirm = Escribir valores de { $from } en el temporizador de { $to }.
whichModel_crossing_memoryOf = { $memory } de { $model }

## A write, from the difference to the verdict.

write_title = Escribir en el temporizador
write_lead = Esto es lo que cambia: { $memory }. Todo lo demás se queda como está.
write_target = Escribir en
write_nothing = No hay diferencias. El temporizador se lee de nuevo y se compara.
write_field = Valor
write_from = Contiene
write_to = Contendrá
write_wasRead = Leído antes
write_moved_model_title = Este temporizador parece ser ahora de otro modelo.
write_moved_model_advice = No se ha escrito nada. Mire los nombres de los modelos.
write_moved_edits_title = El programa ha cambiado desde que se mostró esto.
write_unkept_title = Este dispositivo no ha podido conservar una copia de seguridad de lo que el temporizador contiene ahora.
write_unkept_advice = Esta memoria sigue como estaba. ¿Continuar sin copia de seguridad?
write_sideBySide = Valores: { $names }
write_withoutCopy = Continuar sin copia
write_safety = La hélice está desmontada o el modelo está sujeto, y el temporizador no está armado.
write_acknowledge = He leído esto y quiero escribirlo de todos modos.
write_stillToTick = Falta marcar: { $ticks }.
write_ticks_model = otro modelo
write_ticks_warnings = avisos
write_ticks_safety = hélice
write_move_why = Este temporizador parece mantener las posiciones solo para la función en la que están sus servos. Si los servos no se mueven, probablemente no mantendrá estas.
write_move_label = Llevar los servos a cada función antes de almacenar las posiciones de esta.
write_move_hint = Sujete bien el modelo. Nada debe estorbar a los servos.
write_move_notHeld_title = El temporizador ha confirmado las posiciones, pero no las ha mantenido.
write_move_notHeld_advice = Este temporizador probablemente las mantiene solo para la función en la que están sus servos. Escriba de nuevo, y deje que los servos vayan a cada función.
write_move_again = Escribir de nuevo…
write_start =
    { $count ->
        [0] Releer y comparar
        [one] Escribir { $count } cambio
       *[other] Escribir { $count } cambios
    }
write_stages_read = Leyendo
write_stages_write = Escribiendo
write_stages_verify = Releyendo
write_stages_repair = Corrigiendo
write_stopping = Se detiene tras esta petición
write_stoppingBack = Se detiene: primero vuelve a la memoria de antes
write_verified_title = Verificado.
write_verified_advice = El temporizador se ha releído y contiene lo que se mostraba.
write_verdict = { $memory }: verificado { $time }
write_asItIs = como está
write_insteadOf = en lugar de { $value }
write_wanted = Por escribir
write_readBack = Releído
write_differs_title = El temporizador no ha aceptado todos los valores.
write_differs_advice = El temporizador se ha releído. Aquí contiene otros valores:
write_unknown_title = No se sabe con certeza qué contiene el temporizador.
write_unknown_advice = No se ha podido releer el temporizador por completo. Lea de nuevo, y después escriba lo que aún difiere. Los cambios hechos aquí se conservan.
write_cut = Se ha interrumpido la escritura: { $memory }.
write_strayed_title = { $memory } ha pasado a ser la actual durante la escritura.
write_strayed_advice = Algunos de los valores pueden estar ahora en { $memory }. Léala, y revísela entera antes de volar con ella.
write_refused = No se ha escrito nada.
write_status_differs = difiere
write_status_unknown = no se conoce
write_putBack = lo cambió el temporizador, se ha repuesto

## What the parts of the page that are loaded first say.

name = Sidus Timer
classNames_Q = F1Q
classNames_B = F1B
classNames_E = F1E
unknownClass = Clase { $letter }
memoryName = M{ $number }
servoName = S{ $number }
slotName =
    { $kind ->
        [start] Salida
        [dt] DT
       *[function] Función { $slot }
    }
within_slot =
    { $kind ->
        [start] salida
        [dt] DT
       *[function] función { $slot }
    }
within_idleThrottle = ralentí
slotShort =
    { $kind ->
        [start] Salida
        [dt] DT
       *[function] { $slot }
    }
about = { $name }:
previous = Anterior
next = Siguiente
pause = Pausa
less = { $what }: menos
moreOf = { $what }: más
seconds = { $time }{" "}s
times_minutes = { $minutes }{" "}min
times_minutesSeconds = { $minutes }{" "}min { $seconds }{" "}s
times_units_s = s
times_units_min = min
times_figure = { $text } { $unit }
times_asSeconds = { $seconds }{" "}s, { $clock }
times_meaning = Qué quiere decir: { $field }
header_firmware = firmware { $firmware }
header_simulated = simulado
header_connect = Conectar
header_choosePort = Elegir otro adaptador
header_closeProgram = Cerrar programa
header_disconnect = Desconectar
header_stop = Detener
program_tableCaption = Tiempo y posiciones de los servos de cada función
program_slot = Función
program_time = Tiempo
program_memory = Memoria
program_memoryUnknown = Este temporizador no dice qué memoria es la actual, así que no se sabe con cuál será el próximo vuelo.
program_memoryOpen = No se sabe con qué memoria será el próximo vuelo. Elija una para el próximo vuelo, o lea de nuevo.
program_dt = DT
program_motorStop = Paro de motor
program_motor = Motor
program_idleThrottle = Ralentí
program_throttle = Ralentí
program_idleThrottleUnit = unidad desconocida
program_reserved = reservado { $time }
program_timeOf = { $slot }, tiempo
program_motorStopTime = Paro de motor, tiempo
program_positionOf = { $slot }, { $servo }
program_shortDt = DT corto
program_changes =
    { $count ->
        [one] { $count } cambio
       *[other] { $count } cambios
    }
program_undoAll = Deshacer todo
program_read = Leer de nuevo
program_connectAndWrite = Conectar y escribir…
program_write =
    { $count ->
        [0] Escribir…
        [one] Escribir { $count } cambio…
       *[other] Escribir { $count } cambios…
    }
program_picture = Gráfico
program_table = Tabla
program_blocked = Aún no se puede escribir nada. { $field }: { $why }
program_findings = Revisión
program_noFindings = Nada inusual.
program_absolute = Mostrado desde el lanzamiento. No se sabe si este temporizador cuenta desde el lanzamiento o desde la función anterior.
program_severity_error = No se puede escribir
program_severity_serious = Grave
program_severity_warning = Inusual
program_reading = Leyendo el temporizador
program_selecting = Cambiando de memoria
otherTab_holdsSince = Sidus Timer está abierto en otra pestaña, desde: { $since }.
otherTab_holds = Sidus Timer está abierto en otra pestaña.
otherTab_takeOver = Usarlo aquí
otherTab_busy = La otra pestaña está trabajando con el temporizador. Se abre aquí en cuanto termine.
otherTab_gone = La otra pestaña no responde. Ciérrela, y vuelva a cargar esta página.
disturbed = Faltan respuestas o están dañadas: ¿está despierto el temporizador, y el cabezal de infrarrojos cerca, fuera del sol? Esto termina como muy tarde en { $seconds } s.
cancel = Cancelar
close = Cerrar
copy = Copiar
copied = Copiado.
copyByHand = El navegador no deja copiar a esta página. Cópielo de aquí.
dismiss = Descartar
done = Hecho
undo = Deshacer
open = Abrir
save = Guardar
delete = Borrar
notNow = Ahora no
label_language = Idioma
label_name = Nombre
label_note = Nota
label_model = Modelo
label_search = Buscar
noModel = Sin modelo
more = Y { $count } más.
showMore = Mostrar { $count } más
of = { $button }: { $name }
notFitting = No encaja con el temporizador conectado. Desconecte para abrirlo.
notKept = Este navegador no lo ha conservado: se pierde al cerrar esta página.

## The walk through the open questions of docs/protocol.md with a real timer.

settle_title = Aclárelo con su temporizador
settle_lead = No se sabe todo sobre cómo hablan estos temporizadores. En quince minutos, el suyo aclara lo que está abierto. Después de cada prueba se repone el valor de antes. Tenga a mano el programador portátil.
settle_safe = La hélice está desmontada o el motor está desconectado, y el temporizador no está armado.
settle_danger = Ahora puede moverse algo. ¿Está la hélice desmontada, o el motor desconectado? Mire otra vez.
settle_blocked = Resuelva primero lo que dice el aviso de arriba, y deje lo que se ha probado o reponga lo anterior.
settle_readIt = Leer el temporizador
settle_which = ¿Cuál muestra el programador portátil?
settle_tryHint = Mueva los servos con los botones y espere hasta que estén quietos. Después pruebe una posición: se cambia y en pocos segundos se repone la de antes. Observe los servos.
settle_tryIt = Probar una posición
settle_moved = La posición de antes ha vuelto: la relectura lo confirma. ¿Se movió un servo al probar la nueva?
settle_ask = Preguntar con cuatro ceros
settle_unknown = No lo sé
settle_send = Enviar el archivo con este formulario
settle_names_order = El byte bajo de un tiempo va primero
settle_names_unit = Los tiempos están en centésimas de segundo
settle_names_count = Los tiempos cuentan desde el lanzamiento
settle_names_memories = La primera memoria tiene el número 0
settle_names_zeros = Bastan cuatro ceros
settle_names_layout = La función va antes que el servo
settle_names_stores = Las posiciones se mantienen en cualquier función
settle_names_moves = Una posición escrita mueve su servo
settle_names_unlock = Letra que responde a UNLOCK
settle_names_delay = Tiempo habitual de una respuesta
settle_names_reserved = Tiempo reservado como se lee
settle_yes = Sí
settle_no = No
settle_unnumbered = No se da ningún número
settle_there = Solo donde están los servos
settle_delay = { $ms } ms
settle_open = Sin aclarar
