### Vše, co stránka říká, česky. Názvy vět jsou stejné jako v en.ftl.
###
### Translated without a pilot of that language; corrections welcome (docs/translating.md).

## Moving servos and motor from the page.

bench_slots = Přestavit na
bench_elsewhere = Serva a motor pracují s pamětí pro příští let: { $memory }. Chcete-li jimi pohybovat, zobrazte { $memory }.
bench_trim = Seřízení: { $slot }
bench_at = Serva v poloze: { $slot }
bench_atNone = Není známo, kde serva stojí.
bench_moveMaybe = Nepřišla žádná odpověď. Serva se přesto mohla pohnout. Podívejte se na model.
bench_unlocked = Motor je odblokovaný. Vrtule se může roztočit.
bench_unlockMaybe = Nepřišla žádná odpověď. Motor přesto může být odblokovaný. Držte se dál od vrtule.
bench_jumped = Časovač skok potvrdil.
bench_here = zde stojí serva
bench_waits = Čeká na „Zapsat“.
bench_bring = Přestavit serva: { $slot }
bench_follow = Serva sledují změny
bench_followHint = Stránka nejprve přečte časovač a uchová zálohu. Každou polohu, kterou pak změníte v řádku, u kterého serva stojí, si časovač hned zapamatuje a její servo se pohne.
bench_followingNow = Serva sledují změny: polohu, kterou změníte v řádku, u kterého stojí, si časovač hned zapamatuje.
bench_stopFollowing = Ukončit sledování
bench_ended_over = Serva už změny nesledují.
bench_ended_memory = Serva už změny nesledují: aktuální je, nebo může být, jiná paměť.
bench_ended_strayed = Zatímco serva sledovala změny, stala se aktuální jiná paměť. Mohla převzít některé polohy: než s ní poletíte, celou ji prohlédněte.
bench_ended_unlike = Serva už změny nesledují: časovač neudělal to, co potvrdil.
bench_ended_failed = Serva už změny nesledují: časovač neodpověděl.
bench_notTaken = { $field }: v časovači je { $held }, ne { $wanted }.
bench_beside =
    { $more ->
        [0] Kromě toho se změnilo: { $named }.
        [one] Kromě toho se změnilo: { $named }; a ještě { $more } hodnota.
        [few] Kromě toho se změnilo: { $named }; a ještě { $more } hodnoty.
       *[other] Kromě toho se změnilo: { $named }; a ještě { $more } hodnot.
    }
bench_triedHere =
    { $more ->
        [0] Vyzkoušeno: { $named }.
        [one] Vyzkoušeno: { $named }; a ještě { $more } poloha.
        [few] Vyzkoušeno: { $named }; a ještě { $more } polohy.
       *[other] Vyzkoušeno: { $named }; a ještě { $more } poloh.
    }
bench_triedAndWaiting =
    { $waiting ->
        [0] vyzkoušeno v časovači: { $tried }
        [one] vyzkoušeno v časovači: { $tried }, na „Zapsat“ čeká { $waiting }
        [few] vyzkoušeno v časovači: { $tried }, na „Zapsat“ čekají { $waiting }
       *[other] vyzkoušeno v časovači: { $tried }, na „Zapsat“ čeká { $waiting }
    }
bench_triedIn = Byly vyzkoušeny polohy. Paměť: { $memory }.
bench_decide = Ponechat vyzkoušené polohy, nebo vrátit to, co časovač obsahoval předtím?
bench_keep = Ponechat
bench_putBack = Vrátit…
bench_unlock = Podržet: UNLOCK
bench_unlockHold = Stále držte
bench_unlockHint = Vrtule se může roztočit. Držte model, ruce mějte daleko od vrtule, potom stiskněte a podržte.
bench_experimental = Experimentální
bench_jumpHint = Skok na funkci, která následuje po předčasném DT. Přesný účinek není popsán: serva se mohou pohnout.
bench_jump = Skok…
bench_jumpSure = Poslat skok teď

## The log of flights.

flights_title = Lety
flights_empty_title = Zatím není přidán žádný let.
flights_empty_advice = Přečtěte časovač nebo do něj zapište program, potom stiskněte „{ flights_flying_button }“.
flights_failed = Prohlížeč teď nemůže přečíst knihovnu. Zavřete ostatní karty této stránky a zkuste to znovu.
flights_flying_button = Přidat let
flights_flying_purpose = Přidá let s tím, co obsahuje časovač.
flights_flying_logged = Let přidán { $time }
flights_flying_fillIn = Doplnit
flights_flying_again = Stejný let znovu
flights_row_round = Kolo { $round }
flights_row_wind = { $wind } m/s
flights_row_temperature = { $degrees } °C
flights_row_noResult = bez výsledku
flights_row_changed = změněno: { $values }
flights_row_otherTimer = jiný časovač
flights_totals_flights =
    { $count ->
        [one] { $count } let
        [few] { $count } lety
       *[other] { $count } letů
    }
flights_totals_best = nejlepší { $time }
flights_totals_average = průměr { $time }
flights_filter_of = Lety: { $name }
flights_filter_clear = Zobrazit vše
flights_form_title = Let
flights_form_result = Výsledek
flights_form_resultHint = Sekundy, nebo minuty jako 2:58.
flights_form_readAs = { $time }, { $seconds } s
flights_form_propose = Vyplnit: { $facts }
flights_form_full = Plné kolo, 180 s
flights_form_round = Kolo
flights_form_flyOff = Rozlétávání
flights_form_wind = Vítr
flights_form_windUnit = m/s
flights_form_temperature = Teplota
flights_form_temperatureUnit = °C
flights_form_when = Datum, místo, model
flights_form_date = Datum a čas
flights_form_noOffset = Časové pásmo letiště není známo: toto je čas tohoto zařízení.
flights_form_place = Místo
flights_form_flown = Nastavení za letu
flights_form_open = Otevřít program letu
flights_form_unreadable_not-a-number = Není to číslo.
flights_form_unreadable_not-a-time = Není to čas: napište sekundy jako 178, nebo minuty jako 2:58.
flights_form_unreadable_too-fine = { unreadable_too-fine }
flights_form_range = Od { $min } do { $max } { $unit }.
flights_form_shortDt = DT při tomto letu: { $dt }.
flights_score_open = Výsledky
flights_score_maximum = Maximum každého kola
flights_score_none = Bez maxima se každý výsledek počítá celý.
flights_score_maximumOf = Maximum: { $round }
flights_score_counted = Započteno (s)
flights_score_notCounted = nezapočteno
flights_score_count = Započítat tento
flights_score_noRound = bez kola
flights_score_total = Celkem
flights_score_copy = Kopírovat jako text
flights_csv_save = Uložit jako tabulku (CSV)
flights_csv_columns_date = Datum
flights_csv_columns_time = Hodina
flights_csv_columns_zone = Časové pásmo
flights_csv_columns_place = Místo
flights_csv_columns_model = Model
flights_csv_columns_setting = Program
flights_csv_columns_timerClass = Třída časovače
flights_csv_columns_memory = Paměť
flights_csv_columns_dt = DT (s)
flights_csv_columns_motorStop = Stop motoru (s)
flights_csv_columns_wind = Vítr (m/s)
flights_csv_columns_temperature = Teplota (°C)
flights_csv_columns_round = Kolo
flights_csv_columns_result = Výsledek (s)
flights_csv_columns_maximum = Maximum (s)
flights_csv_columns_note = Poznámka
flights_section_all = Všechny lety

## Values that are unusual, or cannot be written.

findings_time-not-whole = { unreadable_not-a-whole-number }
findings_time-out-of-range = Musí být od { $min } do { $max }.
findings_position-not-whole = { unreadable_not-a-whole-number }
findings_position-out-of-range = Musí být od { $min } do { $max }.
findings_throttle-not-whole = { unreadable_not-a-whole-number }
findings_throttle-out-of-range = Musí být od { $min } do { $max }.
findings_position-as-read = Přečteno { $value }, nad posledním krokem, { $max }. Zůstane to tak, pokud to nezměníte.
findings_time-falls = Přijde dřív než funkce nad ní ({ $previous }).
findings_time-repeats = Stejný čas jako funkce nad ní, { $previous }.
findings_position-never-reached = Stejný čas jako funkce nad ní, { $previous }. Poloh funkce nad ní se nikdy nedosáhne.
findings_motor-stop-after-dt = Motor se zastaví až po DT ({ $dt }): model klesá s běžícím motorem.
findings_motor-run-long = Motor běží déle než { $limit }, což je mez pro F1Q.
findings_time-outside-manual = Návod připouští od { $min } do { $max }.
findings_time-too-fine = Návod uvádí krok { $step }: časovač může zaokrouhlit.
findings_dt-short = Kratší než { $limit }.
findings_dt-moves-nothing = Při DT se nepohne žádné servo: časovač model nedostane na zem.
findings_throttle-unusual = Více než { $limit } je neobvyklé. Jednotka není známa.
findings_class-unknown = Třída „{ $timerClass }“ není známa: její pravidla nebyla zkontrolována.

## Why a text in a field is no value.

unreadable_empty = Prázdné: napište hodnotu.
unreadable_not-a-time = Není to čas: napište sekundy jako 12,5, nebo minuty jako 2:05.
unreadable_too-fine = Jemnější než setina sekundy.
unreadable_not-a-whole-number = Musí to být celé číslo.
unreadable_ambiguous = Dá se to chápat více způsoby: vyberte jeden.

## For a page that cannot reach a timer here.

restWorks = Vše kromě připojení funguje i zde.

## What an Android phone needs.

firstVersions_android = 148
firstVersions_androidBluetooth = 138
firstVersions_lastBluetoothOnly = 147
firstVersions_androidCable = 17
android = Chrome { firstVersions_android } nebo novější ({ firstVersions_androidBluetooth } až { firstVersions_lastBluetoothOnly } jen přes Bluetooth); kabel potřebuje Android { firstVersions_androidCable }

## For every browser about which nothing more is known. docs/connection.md names the first versions.

unsupportedHere_title = Tento prohlížeč se k časovači nedostane.
unsupportedHere_advice = Na počítači použijte aktuální Chrome, Edge, Opera nebo Firefox, na telefonu Chrome v Androidu. { restWorks }

## Replaces the sentence above where the browser's name tells more.

unsupported_brave_title = Brave se k časovači dostane, jen když to povolíte.
unsupported_brave_advice = Otevřete brave://flags/#brave-web-serial-api, nastavte Enabled a stiskněte Relaunch. { restWorks }
unsupported_ios_title = Na iPhonu a iPadu se k časovači nedostane žádný prohlížeč.
unsupported_ios_advice = Použijte počítač, nebo Chrome na telefonu s Androidem. { restWorks }
unsupported_android_title = { unsupportedHere_title }
unsupported_android_advice = V Androidu je potřeba { android }. { restWorks }

## What a saved program held before it was saved over.

versions_title = Dřívější verze
versions_until = Do{"\u00a0"}{ $when }
versions_changed =
    { $more ->
        [0] potom { $change }
       *[other] potom { $change } a ještě{"\u00a0"}{ $more }
    }
versions_otherLayout = potom hodnoty pro jiný časovač
versions_same = Uložený program má teď tyto hodnoty.
versions_goBack = Vrátit se k této

## Two programs side by side.

compare_title = Porovnat
compare_open = Porovnat…
compare_second = s programem
compare_screen = Na obrazovce
compare_timer = Časovač, { $memory }
compare_groups_now = Teď
compare_groups_settings = Uložené programy
compare_setting = { $model } · { $name }
compare_backup = { $memory } · { $when }
compare_backupOf = { $model } · { $memory } · { $when }
compare_nothing = Na tomto zařízení není jiný program této třídy a tohoto uspořádání.
compare_take = Vzít
compare_takeOf = Vzít { $value } pro pole: { $field }
compare_takeHint = „Vzít“ zkopíruje hodnotu do programu na obrazovce.

## How a backup differs from what its timer holds.

modelBackups_same = jako v časovači ({ $when })
modelBackups_differs =
    { $count ->
        [one] { $count } hodnota jiná než v časovači ({ $when })
        [few] { $count } hodnoty jiné než v časovači ({ $when })
       *[other] { $count } hodnot jiných než v časovači ({ $when })
    }
modelBackups_now = teď

## Undo, redo, and edits of many fields at once.

edits_redoButton = Znovu
edits_undo = Zpět: { $step }
edits_redo = Znovu: { $step }
edits_steps_change = změna ({ $what })
edits_steps_shift = posun o { $by } ({ $what } a vše dál)
edits_steps_step-servo = { $what } o { $steps }
edits_steps_step-servo-from = { $what } o { $steps } ({ $from } a vše dál)
edits_steps_paste = vložení ({ $count })
edits_steps_fill = vyplnění dolů ({ $count })
edits_steps_revert-all = vrácení všeho
edits_steps_open = otevření ({ $what })
edits_steps_keep-tried = ponechání vyzkoušených poloh
edits_opened = „{ $name }“
edits_openedUnnamed = jiný program
edits_refused_start = Start nemá čas, který by šlo změnit.
edits_refused_later-out-of-range = Pozdější funkce by byla mimo rozsah od { $min } do { $max }.
edits_refused_unreadable = Překáží text, který není hodnotou. Nejprve ho opravte.
edits_refused_interval-disagrees = Tento odstup nesouhlasí s časy obou řádků.
edits_refused_no-place = Takové místo program nemá.
edits_refused_twice = Toto místo je tu dvakrát, s různými hodnotami.
edits_refused_too-large = Tabulka je příliš velká: čte se nejvýše { $cells } buněk. Zbytek byl vynechán.
edits_beforeLaunch = To by bylo před startem.
edits_nothingDone = Nic se nezměnilo.
edits_cells =
    { $count ->
        [one] { $count } hodnota
        [few] { $count } hodnoty
       *[other] { $count } hodnot
    }
edits_change = { $field }: { $from } → { $to }
edits_field_putBack = Vrátit: { $field }
edits_field_putBackTo = Vrátit { $figure }: { $field }
edits_sheet_title = Klávesy: { $field }
edits_sheet_erase = Smazat poslední číslici
edits_sheet_putBack = Vrátit
edits_sheet_selectRange = Vybrat oblast
edits_sheet_goTo = Přejít: { $name }
edits_table_explain = Co hodnoty znamenají
edits_table_interval = Odstup
edits_table_countedFrom = od { $row }
edits_table_switch = Čas nebo odstup
edits_table_intervalOf = { $slot }, odstup
edits_table_range_title = Vybraná oblast
edits_table_range_pick = Teď klepněte na jinou buňku.
edits_table_range_size = { $cells }, { $columns }
edits_table_range_functions =
    { $count ->
        [one] { $count } funkce
        [few] { $count } funkce
       *[other] { $count } funkcí
    }
edits_table_range_rows =
    { $count ->
        [one] { $count } řádek
        [few] { $count } řádky
       *[other] { $count } řádků
    }
edits_table_range_columns =
    { $count ->
        [one] { $count } sloupec
        [few] { $count } sloupce
       *[other] { $count } sloupců
    }
edits_table_range_paste = Vložit…
edits_table_range_fillDown = Vyplnit dolů
edits_table_range_clipboardClosed = Není tu nic k vložení, co by tato stránka směla vidět. Klepněte do prvního pole a vložte to tam.
edits_table_tools = Nástroje: { $name }
edits_stepServo_title = Všechny polohy: { $servo }
edits_stepServo_now = Teď { $position }
edits_stepServo_nowRange = Teď od { $lowest } do { $highest }
edits_stepServo_by = O kolik kroků
edits_stepServo_step = Přestavit
edits_stepServo_which = Které
edits_stepServo_all = Všechny funkce
edits_stepServo_from = Od: { $slot }
edits_stepServo_stops =
    { $count ->
        [one] { $steps }: { $what } se zastaví na { $at }.
        [few] { $steps }: { $what } se zastaví na { $at }.
       *[other] { $steps }: { $what } se zastaví na { $at }.
    }
edits_shift_open = Posunout…
edits_shift_from =
    { $isLast ->
        [true] { $row }
       *[false] { $row } a vše dál
    }
edits_shift_by = O kolik sekund
edits_shift_earlier = Dřív
edits_shift_later = Později
edits_shift_moveDt = Posunout i DT
edits_shift_function = funkce { $number }
edits_shift_functionRange = funkce { $first } až { $last }
edits_shift_functions = funkce { $numbers }
edits_shift_moved =
    { $later ->
        [true] Posunuto o { $time }{" "}s později
       *[false] Posunuto o { $time }{" "}s dřív
    }
edits_pasting_asks = Tyto názvy nejsou známy. Vyberte, co znamenají:
edits_pasting_choose = Vybrat
edits_pasting_leaveOut = Vynechat
edits_pasting_table = Co kam přijde
edits_pasting_lead =
    { $count ->
        [0] Tím se nic nezmění.
        [one] Tím se změní { $count } hodnota.
        [few] Tím se změní { $count } hodnoty.
       *[other] Tím se změní { $count } hodnot.
    }
edits_pasting_reading = { $field }: „{ $text }“ se chápe jako { $time }.
edits_pasting_problems = Toto nelze vložit:
edits_pasting_place = Řádek { $row }, sloupec { $column } zkopírovaného textu
edits_pasting_problem = { $place }: { $reason }
edits_pasting_problemOf = { $place }, „{ $text }“: { $reason }
edits_pasting_apply = Vložit
edits_presets_title = Předvolby DT
edits_presets_use = DT { $time }
edits_presets_refused = Napište časy jako 20 s nebo 2:30, do 10:55 min, nejvýše 24.
edits_fix = Nastavit { $value }
edits_fixOf = Nastavit { $value }: { $field }

## The library as files: export, import, and the reminder to export.

files_export_all = Exportovat vše…
files_export_one = Exportovat…
files_export_downloaded = Soubor „{ $name }“ jde do stažených souborů: { $what }. Zkontrolujte, že tam je.
files_export_without = chybí: { $kind }
files_export_kinds_models = modely
files_export_kinds_settings = programy
files_export_kinds_flights = lety
files_export_partly = Soubor „{ $name }“ není úplný. Obsahuje: { $what }. Prohlížeč teď nemůže přečíst: { $missing }. Zavřete ostatní karty této stránky a exportujte znovu.
files_export_and = { $first } a { $next }
files_export_tooLarge = Knihovna je na jeden soubor příliš velká. Exportujte její modely po jednom.
files_export_failed = Soubor se nepodařilo vytvořit. Načtěte stránku znovu a zkuste to ještě jednou.
files_import_button = Importovat…
files_import_title = Import: { $name }
files_import_lead = Uloženo { $date }. Obsahuje: { $what }.
files_import_leadNothing = Uloženo { $date }. Neobsahuje nic.
files_import_ignored =
    { $count ->
        [one] { $count } záznam je z novější verze této stránky a vynechá se.
        [few] { $count } záznamy jsou z novější verze této stránky a vynechají se.
       *[other] { $count } záznamů je z novější verze této stránky a vynechá se.
    }
files_import_nothing = Toto všechno už máte.
files_import_differs = Co se liší
files_import_ways_newer = Vzít novější
files_import_ways_both = Ponechat obojí
files_import_itself = samotný model
files_import_flightOf = let ze dne { $day }
files_import_wayText_newer = Co je tu novější nebo má stejné datum, zůstane.
files_import_wayText_both = Zůstane obojí. To ze souboru dostane za název číslo.
files_import_unknownModel = Model, který tu není
files_import_group_fresh = Nové: { $what }
files_import_group_same = Stejné: { $what }
files_import_group_fileNewer = V souboru novější: { $what }
files_import_group_deviceNewer = V souboru ne novější: { $what }
files_import_group_fileName = { $file } (zde: { $here })
files_import_take =
    { $count ->
        [0] Není co importovat
       *[other] Importovat { $count }
    }
files_import_allStays = V souboru není nic novějšího. Chcete-li to přesto importovat, zvolte „{ files_import_ways_both }“.
files_import_done = Importováno z „{ $name }“: { $what }.
files_import_undo = Vzít import zpět
files_import_undone = Import je vzat zpět. Pozdější změny zůstávají.
files_refused_title = Nelze importovat: { $name }
files_refused_nothing = Nic nebylo importováno.
files_refused_again = Exportujte soubor znovu, nebo požádejte odesílatele o nový.
files_refused_fault = Řádek{"\u00a0"}{ $line }: nalezeno { $found }.
files_refused_faultIn = Řádek{"\u00a0"}{ $line }, { $place }: nalezeno { $found }.
files_refused_wanted = Očekáváno:
files_refused_place_entry =
    { $kind ->
        [models] Model „{ $name }“
        [settings] Program „{ $name }“
       *[flights] Let „{ $name }“
    }
files_refused_place_unnamed =
    { $kind ->
        [models] Model { $number } v souboru
        [settings] Program { $number } v souboru
       *[flights] Let { $number } v souboru
    }
files_refused_place_function = funkce { $number }
files_refused_damaged = Soubor je poškozený nebo neúplný.
files_refused_files_too-large = Soubor je na knihovnu příliš velký.
files_refused_files_gone = Soubor se nepodařilo přečíst. Vyberte ho znovu.
files_refused_files_several = Importujte soubory po jednom.
files_refused_format = Toto není soubor knihovny Sidus Timer.
files_refused_newer = Vytvořila ho novější verze této stránky. Načtěte stránku znovu, až budete online.
files_reminder =
    { $changes ->
        [one] { $changes } změna v knihovně je jen na tomto zařízení. Když o ně přijdete, vrátí ji jen soubor.
        [few] { $changes } změny v knihovně jsou jen na tomto zařízení. Když o ně přijdete, vrátí je jen soubor.
       *[other] { $changes } změn v knihovně je jen na tomto zařízení. Když o ně přijdete, vrátí je jen soubor.
    }

## For the time before the other sentences are loaded.

first_failed = Stránka není úplná. Je dostupná síť?
first_again = Načíst znovu

## What a system shows of the installed page: public/manifest.webmanifest has the same in English.

manifest_description = Nastavuje časovače Sidus F1Q, F1B a F1E pro volné modely: přečte, co časovač obsahuje, přijme vaše změny, zapíše je, kontrolně přečte a porovná. Uchovává vaše modely a programy na tomto zařízení. Funguje bez sítě.
manifest_connect = Připojit časovač
manifest_connectShort = Připojit
manifest_connectWhat = Úvodní stránka s tlačítkem „Připojit“
manifest_library = Knihovna
manifest_libraryWhat = Modely a jejich programy
manifest_simulated = Simulovaný časovač
manifest_simulatedWhat = Úvodní stránka se simulovanými časovači
manifest_pictures_program = Program časovače se dvěma označenými změnami
manifest_pictures_write = Co zápis změní, ukázáno před zápisem
manifest_pictures_programPhone = Celý program na telefonu
manifest_pictures_writePhone = Co zápis změní, na telefonu

## The help inside the page.

guide_pages_checklist = Před letem
guide_pages_trouble = Potíže
guide_pages_words = Hodnoty
guide_pages_steps = První kroky
guide_nav = Stránky nápovědy

## What a new pilot is told.

firstSteps_1 = Čtení: stiskněte „Připojit“, probuďte časovač, držte infračervenou hlavici blízko. Čtení nic nemění a ničím nepohne.
firstSteps_2 = Zápis: napište nové hodnoty, stiskněte „Zapsat“, podívejte se na každý rozdíl. „Ověřeno“ znamená: časovač byl znovu přečten a obsahuje to, co chcete.
firstSteps_3 = Let: na horním okraji stránky je vidět, která paměť je vybrána pro příští let, a její DT. Stránka nepotřebuje síť a nic neopustí toto zařízení.

## The values of a program, with unit and range.

values_function_text = Etapa letu: ve svém čase jde každé servo do své polohy. Chcete-li funkci přeskočit, dejte jí polohy funkce předchozí.
values_function_range = Obvykle start, devět funkcí a DT.
values_time_text = Kdy funkce začíná, počítáno od startu. Napište 12,5 nebo 2:05. U F1B a F1E není známo, odkud časovač počítá.
values_time_range = Podle návodů. F1Q: 0,1 až 99,9 s. F1B: 0,01 až 9,99 s pro funkce 1 a 2, potom 0,1 až 99,9 s. F1E: není známo.
values_after_text = Čas od předchozí funkce. Všechny pozdější funkce se posunou s ním, DT ne.
values_position_name = Poloha
values_position_text = Kde servo stojí. Úhel jednoho kroku závisí na servu a táhle: vyzkoušejte ho v zobrazení „{ views_names_bench }“.
values_position_range = 0 až 130 kroků.
values_motorStop_text = F1Q: kdy se motor zastaví, počítáno od startu. Žádné servo se s ním nepohne.
values_motorStop_range = Podle návodu 0,1 až 99,9 s, po 0,1 s.
values_dt_text = Determalizátor: kdy dostane model na zem, počítáno od startu. Červeně, když je čas kratší než vaše mez.
values_dt_range = 1 až 720 s podle návodu. Více než 10:55 min nelze odeslat.
values_idleThrottle_text = F1Q: pravděpodobně jak rychle se točí motor, dokud je startovací tlačítko stisknuté.
values_idleThrottle_range = Stránka předpokládá 0 až 100. Jednotka není známa.
values_memory_text = Časovač má několik pamětí, v každé jeden program. Při příštím letu platí vybraná paměť. Nahlédnutí do jiné ji vybere a zase se vrátí; je-li to přerušeno, stránka řekne, která je možná vybrána pro příští let.
values_memory_range = Obvykle čtyři, M1 až M4. Starší časovače jich mají pět.

## What a pilot checks before a flight.

checklist_lead = Zaškrtněte každý bod. Zaškrtnutí platí pro jeden let a neuchovávají se.
checklist_items_memory = Pro příští let je vybrána správná paměť.
checklist_items_dtTime = Čas DT zazněl nahlas.
checklist_items_surfaces = Křídlo, výškovka a směrovka drží pevně a stojí, jak mají.
checklist_items_battery = Baterie je nabitá a její konektor zasunutý až na doraz.
checklist_items_dtSeen = Servo se mi před očima přestavilo na DT.
checklist_items_radioDt = Rádiové DT je vyzkoušené, pokud v modelu je.
checklist_items_switch = Startovací tlačítko bylo pětkrát stisknuto a pokaždé odskočilo.
checklist_items_propeller = Vrtule je pevně upevněná a volně se otáčí. Nikdo před ní nestojí.
checklist_known_now = Příští let: { $memory }, DT{"\u00a0"}{ $dt }, čteno { $time }.
checklist_known_onceAt = Naposledy čteno { $time }: { $memory }, DT{"\u00a0"}{ $dt }.
checklist_known_once = Naposledy čteno: { $memory }, DT{"\u00a0"}{ $dt }.
checklist_known_not = Není známo, co obsahuje { $memory }. Před letem ji přečtěte.
checklist_known_nothing = Žádný časovač nebyl přečten. Připojte časovač a uvidíte zde paměť pro příští let a její DT.
checklist_known_unwritten =
    { $count ->
        [one] { $count } změna ještě není v časovači.
        [few] { $count } změny ještě nejsou v časovači.
       *[other] { $count } změn ještě není v časovači.
    }
checklist_left = Zbývá bodů: { $count }
checklist_done = Vše zaškrtnuto. Dobrý let.
checklist_again = Zrušit zaškrtnutí

## Problems as a pilot sees them, and what to do.

troubles_symptoms_noAnswer_title = Časovač neodpovídá
troubles_symptoms_noAdapter_title = Stránka nenajde adaptér
troubles_symptoms_refused_title = Adaptér se neotevře
troubles_symptoms_wrongValues_title = Hodnoty vypadají špatně
troubles_symptoms_wrongValues_steps_1 = Podívejte se na horní okraj stránky: která paměť je zobrazena a která je vybrána pro příští let?
troubles_symptoms_wrongValues_steps_2 = Stiskněte „{ program_read }“.
troubles_symptoms_wrongValues_steps_3 = Klesají časy z řádku na řádek? Stránka se pak zeptá, jak je číst.
troubles_symptoms_wrongValues_steps_4 = U F1B a F1E porovnejte časy s ručním programátorem.
troubles_symptoms_cutOff_title = Zápis byl přerušen
troubles_symptoms_cutOff_steps_1 = S tímto modelem zatím nelétejte. Připojte se: stránka přečte časovač a potom nabídne zápis dokončit, nebo zapsat původní hodnoty.
troubles_symptoms_cutOff_steps_2 = Co časovač obsahoval předtím, je v zobrazení „{ views_names_memories }“, „{ backups_title }“.
troubles_symptoms_noDt_title = DT nezafunguje, nebo zafunguje ve špatný čas
troubles_symptoms_noDt_steps_1 = Podívejte se na horní okraj stránky: je tam paměť vybraná pro příští let a její DT. Jiná paměť má jiné DT.
troubles_symptoms_noDt_steps_2 = Odskočí startovací tlačítko pokaždé? Dokud je stisknuté, sekvence nezačne a DT nezafunguje.
troubles_symptoms_noDt_steps_3 = Je baterie nabitá a její konektor zasunutý až na doraz? Když časovač neběží, DT nezafunguje.
troubles_symptoms_noDt_steps_4 = Držte model bezpečně a stiskněte řádek DT v zobrazení „{ views_names_bench }“. Jde servo do své polohy DT a uvolní to, co drží?
troubles_symptoms_noDt_steps_5 = Sundejte vrtuli a nechte časovač doběhnout do konce. Nelétejte, dokud neuvidíte, že se servo v čase DT pohne.
troubles_symptoms_noMove_title = Servo se nepohne
troubles_symptoms_noMove_steps_1 = Držte model a stiskněte v zobrazení „{ views_names_bench }“ řádek funkce, ve které se má servo pohnout. Nic se nehýbe? Prohlédněte konektor a baterii. Tam se pohne, ale v letu ne? Má stejnou polohu jako ve funkci předtím.
troubles_symptoms_noMove_steps_2 = Jde jinam, než říká tabulka? Některé časovače si možná pamatují polohu jen pro funkci, u které serva stojí. Stránka pak nabídne, že serva při zápisu přestaví.
troubles_symptoms_noMove_steps_3 = Bzučí, nebo se zastaví moc brzy? Možná ho blokuje táhlo: zkuste menší pohyb.
troubles_symptoms_noMotor_title = Motor se nerozběhne
troubles_symptoms_noMotor_steps_1 = Po letu časovač motor zablokuje. Držte model a ruce mějte daleko od vrtule: při odblokování se může roztočit. Potom podržte tlačítko „{ bench_unlock }“ v zobrazení „{ views_names_bench }“.
troubles_symptoms_noMotor_steps_2 = Odskočilo startovací tlačítko? Dokud je stisknuté, motor běží jen na volnoběh.
troubles_symptoms_noMotor_steps_3 = Není stop motoru příliš brzy? Při 0,1 s se motor zastaví, jakmile se rozběhne.
troubles_symptoms_noLibrary_title = Moje modely a programy tu nejsou
troubles_symptoms_noLibrary_steps_1 = Vyprázdněte pole hledání, stiskněte „Archiv“.
troubles_symptoms_noLibrary_steps_2 = Každý prohlížeč, profil a adresa má vlastní knihovnu; soukromé okno ji smaže.
troubles_symptoms_noLibrary_steps_3 = Na jiném zařízení, nebo když je ztracena: „{ files_import_button }“ a soubor z posledního exportu.

## What to do, step by step, when a timer cannot be reached.

help_title = Co dělat
help_steps_programs = Zavřete ostatní karty a programy, které adaptér používají, například Arduino IDE, PuTTY, program 3D tiskárny nebo konfigurátor dronů.
help_steps_replug = Odpojte adaptér, počkejte pět sekund a znovu ho připojte. Pokud to nepomůže, restartujte počítač.
help_steps_cable = Připojte adaptér přímo, bez rozbočovače, a zkuste jiný kabel. Mnoho kabelů USB jen nabíjí.
help_steps_windows = Windows: otevřete Správce zařízení. Žlutá značka u adaptéru znamená, že chybí jeho ovladač: připojte se k internetu a spusťte Windows Update.
help_steps_mac = Mac: povolte příslušenství, když se na ně Mac zeptá. Starý macOS potřebuje ovladač výrobce.
help_steps_linux = Linux vám možná nedovolí adaptér použít. Spusťte tento příkaz, potom se odhlaste a znovu přihlaste.
help_steps_linux-container = Adaptér si mohl vzít Linux v Chromebooku. Vypněte adaptér v Nastavení: Vývojové prostředí Linux, Spravovat zařízení USB.
help_steps_android = V Androidu je potřeba { android }. { restWorks }
help_steps_bluetooth = Bluetooth: spárujte adaptér v nastavení systému (kód 1234 nebo 0000), mějte ho zapnutý a blízko a na jiných zařízeních, která ho používají, Bluetooth vypněte.
help_steps_firefox-finds = Firefox nenajde adaptéry Bluetooth, a je-li z obchodu Ubuntu, nenajde vůbec žádné. Použijte Chrome.
help_steps_firefox-reload = Firefox si drží adaptér, který selhal. Načtěte tuto stránku znovu. Co jste napsali, je uchováno.
help_steps_switch = { link_stages_steps_switch }
help_steps_near = { link_stages_steps_near }
help_steps_battery = Je baterie časovače nabitá a připojená? Když je vybitá, časovač stojí v poloze DT.
help_steps_restarts = Některé adaptéry se při každém otevření portu restartují (resetuje je DTR) a několik sekund nic neslyší. Pokud to váš dělá, nastavte jeho rychlost: Nastavení, „{ ports_settings }“. Port se pak otevře jen jednou. Stránka sama nechává DTR tak, jak ho nastaví prohlížeč.
help_steps_usual-settings = Otevřete Nastavení, „{ ports_settings }“, a stiskněte „{ ports_reset }“: stránka si pak rychlost najde sama.
help_steps_report = Pokud se to opakuje: Nastavení, Expert, Linka, „{ line_copyReport }“. Pošlete to na:
help_steps_address = Otevřete tuto adresu v kartě:
help_page = Všechny kroky, pro každý systém

## For when the browser does not store, or give back, what it should.

keeping_title = Tento prohlížeč neuchová všechno.
keeping_notKept = Co napíšete, zálohy a záznam o přerušeném zápisu vydrží jen do zavření této stránky. Exportujte knihovnu. Potom zavřete ostatní karty této stránky, nebo na tomto zařízení uvolněte místo.
keeping_notKnown = Prohlížeč neříká, zda uchovává, co děláte. Počítejte s tím, že ne, a exportujte knihovnu.
keeping_oneTab = Používejte jen jednu kartu této stránky.
keeping_emptied = Prohlížeč smazal, co pro tuto stránku uchovával. Exportujte, co ještě vidíte.
keeping_export = Exportovat knihovnu…

## Stored data that cannot be read.

aside_title =
    { $count ->
        [one] 1 záznam se nepodařilo přečíst. Je odložený, ne smazaný.
        [few] { $count } záznamy se nepodařilo přečíst. Jsou odložené, ne smazané.
       *[other] { $count } záznamů se nepodařilo přečíst. Jsou odložené, ne smazané.
    }
aside_write = Je mezi nimi záznam o přerušeném zápisu: před letem přečtěte časovač.
aside_save = Uložit do souboru

## “2 models, 1 program”: only kinds that there are.

counted_models =
    { $count ->
        [one] { $count }{"\u00a0"}model
        [few] { $count }{"\u00a0"}modely
       *[other] { $count }{"\u00a0"}modelů
    }
counted_settings =
    { $count ->
        [one] { $count }{"\u00a0"}program
        [few] { $count }{"\u00a0"}programy
       *[other] { $count }{"\u00a0"}programů
    }
counted_flights =
    { $count ->
        [one] { $count }{"\u00a0"}let
        [few] { $count }{"\u00a0"}lety
       *[other] { $count }{"\u00a0"}letů
    }
counted_backups =
    { $count ->
        [one] { $count }{"\u00a0"}záloha
        [few] { $count }{"\u00a0"}zálohy
       *[other] { $count }{"\u00a0"}záloh
    }

## What was deleted a moment ago.

removed = Smazáno: { $what }.

## Deletes everything that this device keeps.

erase_open = Smazat vše na tomto zařízení…
erase_lead = Tím se z tohoto prohlížeče smažou všechny modely, programy, lety, zálohy, nezapsané změny a volby této stránky. Nelze to vrátit zpět. Časovačům jejich obsah zůstane.
erase_uncertain = Zápis byl přerušen a není známo, co ten časovač obsahuje. Bez záznamu o tomto zápisu vás stránka nemůže varovat: před letem ten časovač přečtěte.
erase_start = Smazat vše
erase_running = Maže se
erase_failed = Nepodařilo se smazat vše. Zavřete ostatní karty této stránky a zkuste to znovu, nebo smažte její data v nastavení prohlížeče.

## For a page that is shown inside another page.

framed_title = Sidus Timer pracuje jen ve vlastní kartě: jiná stránka by mohla zakrýt, co vidíte ze svého časovače.
framed_open = Otevřít Sidus Timer ve vlastní kartě

## What is known about the content of a timer, and what is not.

knowledge_title = Nejisté
knowledge_uncertain = Není známo, co obsahuje { $memory }: { $values }.
knowledge_noFly = Nelétejte, dokud to není přečteno.
knowledge_since = Přerušený zápis, začátek: { $time }.
knowledge_thisMemory = aktuální paměť
knowledge_memoryOf = { $memory } ({ $timer })
knowledge_timer_here = časovač { $name } { $firmware }
knowledge_timer_simulated = simulovaný časovač { $name } { $firmware }
knowledge_otherTimer_here = jiný časovač { $name } { $firmware }
knowledge_otherTimer_simulated = jiný simulovaný časovač { $name } { $firmware }
knowledge_motorStop = stop motoru
knowledge_either = { $name } je { $before }, nebo { $goal }
knowledge_list =
    { $more ->
        [one] { $named }, a { $more }{"\u00a0"}další{"\u00a0"}hodnota je nejistá
        [few] { $named }, a { $more }{"\u00a0"}další{"\u00a0"}hodnoty jsou nejisté
       *[other] { $named }, a { $more }{"\u00a0"}dalších{"\u00a0"}hodnot je nejistých
    }
knowledge_and = { $first } a { $next }
knowledge_connect = Připojit a přečíst
knowledge_forget = Zapomenout…
knowledge_forgetSure = Zapomeňte to, jen pokud jste ten časovač přečetli jinde nebo ho už nemáte.
knowledge_forgetNow = Zapomenout teď
knowledge_verified = Jako v časovači, ověřeno { $time }
knowledge_readAt = Jako v časovači, čteno { $time }
knowledge_lastReadAt = Podle posledního čtení, { $time }
knowledge_lastRead = Podle posledního čtení
knowledge_ofSetting =
    { $changes ->
        [0] { $name }: uloženo
        [one] { $name }: { $changes } změna neuložena
        [few] { $name }: { $changes } změny neuloženy
       *[other] { $name }: { $changes } změn neuloženo
    }
knowledge_changed = { $name }, změněno
knowledge_ofModel = { $name } ({ $model })
knowledge_made = Nový program, zatím v žádném časovači
knowledge_unknown = Není známo, co obsahuje { $memory }
knowledge_unfinished =
    { $count ->
        [one] { $count } pole zatím nemá hodnotu
        [few] { $count } pole zatím nemají hodnotu
       *[other] { $count } polí zatím nemá hodnotu
    }
knowledge_hints_now = Označená pole se liší od toho, co obsahuje časovač.
knowledge_hints_onceAt = Označená pole se liší od toho, co bylo naposledy čteno, { $time }.
knowledge_hints_once = Označená pole se liší od toho, co bylo naposledy čteno.
knowledge_marks_now = bylo { $value }
knowledge_marks_once = posl. čtení: { $value }
knowledge_notCertain = , teď nejisté
knowledge_held_now = V časovači
knowledge_held_once = Poslední čtení

## Why a program of the library or from a link cannot be opened now.

obstacles_busy = Stránka čte, zapisuje nebo hledá časovač. Počkejte, až skončí.
obstacles_following = Serva sledují změny. Nejprve to ukončete.
obstacles_not-fitting = { notFitting }

## Models and their saved programs.

library_unread = Prohlížeč teď nemůže přečíst knihovnu. Zavřete ostatní karty této stránky a zkuste to znovu.
library_empty_title = Zatím žádný model
library_empty_lead = Model má své programy, s názvy a poznámkami. Jsou uchovány jen na tomto zařízení.
library_empty_hint = Vytvořte model, nebo přečtěte časovač a uložte jeho program.
library_search_label = Hledat programy
library_search_nothing = Žádný program neobsahuje všechna tato slova.
library_models_title = Modely
library_models_all = Všechny modely
library_models_make = Nový model…
library_models_settings =
    { $count ->
        [one] { $count } program
        [few] { $count } programy
       *[other] { $count } programů
    }
library_models_archive = Archiv ({ $count })
library_models_archived = v archivu
library_models_latest = Naposledy změněno
library_list_open = na obrazovce
library_model_timerClass = Třída
library_model_noClass = Neuvedena
library_model_facts = O tomto modelu
library_model_noSettings = Zatím žádný program.
library_model_servos = Serva
library_model_servosUnknown = Nejprve uložte program tohoto modelu.
library_model_servoWay = { $low } až { $high } kroků
library_model_archive = Do archivu
library_model_unarchive = Vyjmout z archivu
library_model_remove = Smazat model
library_model_withSettings =
    { $count ->
        [one] Jeho program se smaže s ním. „Zpět“ vrátí obojí.
        [few] Jeho { $count }{"\u00a0"}programy se smažou s ním. „Zpět“ vrátí vše.
       *[other] Jeho { $count }{"\u00a0"}programů se smaže s ním. „Zpět“ vrátí vše.
    }
library_setting_isOpen = Na obrazovce: podívat se
library_setting_loadAgain =
    { $count ->
        [one] Otevřít znovu: vrátí se { $count } hodnota
        [few] Otevřít znovu: vrátí se { $count } hodnoty
       *[other] Otevřít znovu: vrátí se { $count } hodnot
    }
library_setting_tags = Štítky, oddělené čárkami
library_setting_from_typed = napsáno
library_setting_from_timer = přečteno z časovače
library_setting_from_simulated = přečteno ze simulovaného časovače
library_setting_from_backup = ze zálohy
library_setting_from_file = ze souboru
library_setting_from_link = z odkazu
library_setting_origin = { $source }, { $time }
library_setting_notShown = Nepodařilo se ho otevřít. Zkuste to znovu.
library_setting_gone = V knihovně už není.
library_save_open = Uložit…
library_save_over = Přepsat: { $program }
library_save_undo = Vzít zpět uložení: { $name }
library_save_crossing = Jsou to hodnoty modelu { $from }. Uložit je pod model { $to }.
library_save_asNew = Uložit jako nový…
library_save_taken = Program { $program } už existuje. Napište jiný název, nebo:
library_save_replace = Přepsat ho. Jeho hodnoty zůstanou jako dřívější verze.
library_save_name =
    { $of ->
        [program] Název programu
       *[model] Název modelu
    }
library_save_namePlace = Například: rozlétávání, bezvětří
library_save_notSavable = Některé pole nemá hodnotu. Nejprve ho opravte.
library_save_state =
    { $changes ->
        [0] { $name }: uloženo
        [one] { $name }: { $changes } změna neuložena
        [few] { $name }: { $changes } změny neuloženy
       *[other] { $name }: { $changes } změn neuloženo
    }
library_nameNeeded = Je potřeba název.

## The log of the line.

line_empty = Není co zobrazit.
line_unused = Na lince zatím nic nebylo. Můžete také načíst nahrávku a přehrát ji jako časovač.
line_all = Vše
line_out = Do časovače
line_in = Z časovače
line_damaged = Poškozené
line_request = { $name } · { $letters }
line_reply = { $name }, odpověď · { $letters }
line_echo = { $name }, ozvěna · { $letters }
line_unknown = Neznámé písmeno { $letter }
line_names_GETTIMERS = Čtení časů
line_names_SETTIMERS = Zápis časů
line_names_GETSERVOPOS = Čtení poloh
line_names_SETSERVO = Zápis polohy
line_names_MOVETOFUNC = Pohyb serv
line_names_GETSWVER = Identifikace
line_names_UNLOCK = Odblokování motoru
line_names_JUMP2 = Skok
line_names_GETMEMORY = Která paměť
line_names_SETMEMORY = Výběr paměti
line_names_GETLOWRPM = Čtení volnoběhu
line_names_SETLOWRPM = Zápis volnoběhu
line_rejected_noise = Poškozeno: šum
line_rejected_length = Poškozeno: nemožná délka
line_rejected_terminator = Poškozeno: chybí konec tam, kde má být
line_rejected_checksum = Poškozeno: špatný kontrolní součet
line_rejected_silence = Poškozeno: useknuto
line_error_framing = Chyba linky: rámcování
line_error_parity = Chyba linky: parita
line_error_break = Chyba linky: přerušení
line_error_overrun = Chyba linky: přeběh, bajty se ztratily
line_error_other = Chyba linky jiného druhu
line_position = { $slot }, { $servo }: krok { $steps }
line_motorStop = stop motoru { $time }
line_reserved = vyhrazeno { $time }
line_functions = funkce { $times }
line_identity = { $name }, firmware { $firmware }, { $functions } a DT, { $memories }, { $servos }
line_memories =
    { $count ->
        [one] { $count } paměť
        [few] { $count } paměti
       *[other] { $count } pamětí
    }
line_memoryUnsaid = Neříká, která.
line_idleThrottle = { $value }, jednotka neznámá
line_idleThrottleUnsaid = Neudává hodnotu.
line_acknowledged = Potvrzeno.
line_unreadable_wrong-length = Obsah je delší nebo kratší, než má být.
line_unreadable_unknown-command = Není známo, co to znamená.
line_unreadable_unexpected-reply = Odpovídá na jiný požadavek.
line_unreadable_bad-identity = Co říká o časovači, nemůže být pravda.
line_unreadable_identity-needed = Půjde to přečíst, až časovač řekne, co je zač.
line_unreadable_out-of-range = Některá hodnota v něm nemůže být správná.
line_unreadable_not-an-integer = { line_unreadable_out-of-range }
line_unreadable_wrong-count = { line_unreadable_out-of-range }
line_unreadable_wrong-type = { line_unreadable_out-of-range }
line_unreadable_unknown-word = Obsah nelze přečíst.
line_unreadable_bad-capture = { line_unreadable_unknown-word }
line_unreadable_bad-file = { line_unreadable_unknown-word }
line_unreadable_bad-link = { line_unreadable_unknown-word }
line_unreadable_newer-version = { line_unreadable_unknown-word }
line_unreadable_too-large = { line_unreadable_unknown-word }
line_unreadable_duplicate = { line_unreadable_unknown-word }
line_goOn = Dál
line_came =
    { $number ->
        [one] Pozastaveno. Od té doby { $number } záznam.
        [few] Pozastaveno. Od té doby { $number } záznamy.
       *[other] Pozastaveno. Od té doby { $number } záznamů.
    }
line_clear = Vymazat
line_unidentified = neznámý
line_load = Načíst…
line_filter = Zobrazit
line_searchHint = název nebo hex
line_counts_out = do časovače: { $count }
line_counts_in = z časovače: { $count }
line_counts_damaged = poškozené: { $count }
line_counts_errors =
    { $count ->
        [one] { $count } chyba linky
        [few] { $count } chyby linky
       *[other] { $count } chyb linky
    }
line_recording =
    { $entries ->
        [one] { $name }: nahrávka, { $entries } záznam.
        [few] { $name }: nahrávka, { $entries } záznamy.
       *[other] { $name }: nahrávka, { $entries } záznamů.
    }
line_replay = Přehrát jako časovač
line_cannotReplay = Nelze přehrát: časovač nikdy neřekne, co je zač.
line_back = Zpět na živou linku
line_noRecordingAt = Řádek { $line }: očekáván čas v sekundách, > nebo < a bajty v hex.
line_noRecording = Tento soubor není nahrávka.
line_send_title = Poslat rámec ručně
line_send_lead = Délku a kontrolní součet přidá stránka.
line_send_bytes = Písmeno a data, v hex
line_send_faults_hex = Pro každý bajt napište dvě číslice hex, 0 až 9 nebo A až F.
line_send_faults_too-long = Rámec nese nejvýše 252 bajtů.
line_send_preview = Odejde jako
line_send_send = Poslat…
line_send_confirmTitle = Poslat tento rámec časovači?
line_send_danger = Serva se mohou pohnout, vrtule se může roztočit a obsah časovače se může změnit. Potom se časovač znovu přečte.
line_send_confirm = Ano, poslat jednou
line_send_sending = Posílá se
line_send_answered = Odpověď:
line_send_unanswered = Odpověď nepřišla. To, co rámec žádal, se přesto mohlo stát.
line_copyReport = Kopírovat zprávu

## From the ports to a timer that answers.

link_portNames_ftdi = Adaptér FTDI
link_portNames_cp210x = Adaptér CP210x (Silicon Labs)
link_portNames_ch340 = Adaptér CH340 (WCH)
link_portNames_pl2303 = Adaptér PL2303 (Prolific)
link_portNames_bluetooth = Bluetooth
link_portNames_usb = Adaptér USB
link_portNames_other = Sériový port
link_stages_choosing = Vyberte adaptér časovače
link_stages_openingLong_title = Adaptér se otevírá dlouho
link_stages_openingLong_advice = Bluetooth: zapněte adaptér, poblíž. Kabel: odpojte ho a znovu připojte.
link_stages_asking = Ptá se rychlostí { $rate } baudů.
link_stages_noAnswer = Bez odpovědi už { $seconds } s. Stránka se ptá dál a sama bude pokračovat.
link_stages_open = Adaptér je otevřený
link_stages_steps_switch = Probuďte časovač: krátce stiskněte jeho tlačítko
link_stages_steps_near = Držte infračervenou hlavici blíž než 20 cm, mimo slunce
link_stages_steps_other = Není časovač na jiném adaptéru?
link_refused = Stránka to zkouší dalších 15 sekund. Adaptér možná používá jiný program.
link_heard_title = Něco je slyšet, ale žádný časovač neodpovídá.
link_heard_advice = Probuďte časovač a držte hlavici blíž, mimo slunce, nebo vyberte jiný adaptér.
link_slow_title = Časovač odpovídá, ale příliš pomalu.
link_slow_advice = Jeho bajty přicházejí při { $rate } baudech po jednom, s tak dlouhými mezerami, že žádná odpověď nedorazí včas celá. Tato stránka ho nemůže přečíst. Zkuste jiný adaptér, nebo kabel místo Bluetooth.
link_itSaid = Přišlo: { $bytes } („{ $text }“).
link_trySelectBare = Zkusit to bez správného kontrolního součtu
link_lost_title = Spojení s adaptérem je ztraceno.
link_lost_advice = Připojte ho, nebo ho dejte blíž: stránka bude sama pokračovat. Co jste napsali, je uchováno.
link_status_off = Nepřipojeno
link_status_opening = Připojuje se
link_status_searching = Hledá se časovač
link_status_away = Spojení ztraceno
link_status_closing = Odpojuje se

## The known ports, and how they are opened.

ports_title = Známé adaptéry
ports_forget = Zapomenout
ports_settings = Sériové nastavení
ports_settingsHint = Jen pro zvláštní adaptér. Stránka si rychlost najde sama.
ports_rate = Rychlost
ports_findRate = Najít
ports_baud = { $rate } baudů
ports_parity = Parita
ports_parities_none = Žádná
ports_parities_even = Sudá
ports_parities_odd = Lichá
ports_stopBits = Stop bity
ports_dtr = DTR
ports_rts = RTS
ports_signals_leave = Jak ho nastaví prohlížeč
ports_signals_on = Zapnuto
ports_signals_off = Vypnuto
ports_reset = Obvyklé nastavení

## What is known about the connected timer. Its numbers are in the report.

aboutTimer_title = O tomto časovači
aboutTimer_damage = Poškození viděná na lince
aboutTimer_crowd = V paprsku může být jiný časovač nebo programátor. Od té doby se musí shodovat dvě čtení.
aboutTimer_found = Co udělal jinak
aboutTimer_nothingFound = Zatím nic: všechno, oč byl požádán, udělal obvyklým způsobem.
aboutTimer_quirkNames_timers-reply-66 = Odpovídá písmenem jiného příkazu.
aboutTimer_quirkNames_unlock-reply-6a = { aboutTimer_quirkNames_timers-reply-66 }
aboutTimer_quirkNames_memory-unknown = Neříká, která paměť je aktuální.
aboutTimer_quirkNames_memory-impossible = { aboutTimer_quirkNames_memory-unknown }
aboutTimer_quirkNames_bare-checksum = Na volnoběh neodpovídá jako obvykle.
aboutTimer_quirkNames_times-big-endian = Jeho časy klesají. Po prohození obou bajtů každého času by rostly.
aboutTimer_quirkNames_servo-first = Při zápisu polohy bere servo před funkcí.
aboutTimer_quirkNames_servo-unanswered = Neodpověděl, když se zapisovala poloha.
aboutTimer_quirkNames_times-rounded = Zaokrouhluje časy.
aboutTimer_quirkNames_memories-from-one = Počítá své paměti od 1.
aboutTimer_quirkNames_positions-unchanged = Potvrdil polohy, ale nezachoval je.
aboutTimer_quirkNames_echo = Adaptér posílá zpět, co se mu pošle.
aboutTimer_quirkNames_idle-throttle-unanswered = { aboutTimer_quirkNames_bare-checksum }
aboutTimer_quirkNames_identity-unusual = V tom, co o sobě říká, jsou neznámé bajty.
aboutTimer_quirkNames_idle-throttle-malformed = { aboutTimer_quirkNames_bare-checksum }
aboutTimer_quirkNames_replies-alike = Jeho odpovědi na některé požadavky jsou poškozené, každá stejným způsobem.
aboutTimer_assumed = Známé odchylky
aboutTimer_assumedHint = Zapamatováno pro tento adaptér a tento druh časovače.
aboutTimer_forget = Zapomenout známé odchylky
aboutTimer_assumptions_bigEndianTimes = Oba bajty každého času jsou prohozené
aboutTimer_assumptions_servoFirst = { aboutTimer_quirkNames_servo-first }
aboutTimer_assumptions_memoriesFromOne = { aboutTimer_quirkNames_memories-from-one }
aboutTimer_assumptions_bareChecksumRequests = „Výběr paměti“ a „Zápis volnoběhu“ se posílají bez správného kontrolního součtu
aboutTimer_assumptions_positionsNeedMove = Polohy se zachovají jen tam, kde serva stojí

## Which memory flies next, and what is known about the others.

nextFlight_badge = příští let
nextFlight_onScreen = Toto je { $memory }.
nextFlight_named = { $memory }, příští let
nextFlight_other = Příští let: { $memory }.
nextFlight_last = Když časovač naposledy odpověděl, byla aktuální { $memory }. Je vybrána pro příští let, pokud to něco jiného nezměnilo.
nextFlight_original = Při připojení byla aktuální { $original }.
nextFlight_originalUnknown = Není známo, která byla aktuální při připojení.
nextFlight_unknown = Není známo, která paměť je vybrána pro příští let.
nextFlight_asked = Naposledy byla vybrána { $memory }.
nextFlight_back = Zpět na { $original }
nextFlight_leaving_title = Než se odpojíte
nextFlight_leaving_back = Zpět na { $original } a odpojit
nextFlight_leaving_failed = Časovač se nevrátil na { $original }. Je stále připojený.

## The last reading of a memory that is not current.

look_read = { $memory }, čteno { $time }
look_notRead = { $memory } nebyla přečtena
look_either = Buď
look_or = nebo
look_lead = Jen k nahlédnutí. Příští let: { $current }.
look_edit = Upravit { $memory }
look_look = Nahlédnout do { $memory }
look_hint = Vybere { $memory }, přečte ji a vrátí se na { $current }.
look_fly = Vybrat { $memory } pro let
look_show = Zobrazit { $memory }

## Jobs over several memories, and the backups.

memories_copy = Kopírovat { $from } do { $to }
memories_restore = Obnovit zálohu
memories_restoreAll = Obnovit všechny ({ $count })…
memories_plans_screen =
    { $keepsThrottle ->
        [true] Zapíší se časy a polohy z obrazovky. Paměť: { $to }. Co obsahuje teď, se předtím zálohuje. Volnoběh zůstane, jak je.
       *[false] Zapíší se časy a polohy z obrazovky. Paměť: { $to }. Co obsahuje teď, se předtím zálohuje.
    }
memories_plans_copy = { $to } bude obsahovat časy a polohy z { $from }, jak byly právě přečteny. Co { $to } obsahuje teď, se předtím zálohuje.
memories_plans_restore = Zapíše se obsah zálohy ({ $time }). Paměť: { $names }. Co je tam teď, se předtím zálohuje.
memories_atEnd = Na konci bude pro příští let zase vybrána { $current }.
memories_refused = { $memory }: nelze nic zapsat, žádný software nemůže tyto hodnoty poslat.
memories_untouched = { $memory }: nic nebylo zapsáno.
memories_stopped = Co ještě nebylo zapsáno, je v časovači jako předtím.

## All memories of a timer at a glance.

overview_readAll = Přečíst a uchovat všechny
overview_copyTo = Kopírovat do…
overview_compareWith = Porovnat s { $memory }
overview_readAt = čteno { $time }
overview_notCertain = Nejisté: zápis do této paměti byl přerušen. Zobrazen je stav před tímto zápisem.
overview_edited = Zobrazeno a kopírováno, jak to obsahuje časovač, bez vašich změn.
overview_same = Obsahují totéž.
overview_differs =
    { $count ->
        [one] Liší se { $count } hodnota.
        [few] Liší se { $count } hodnoty.
       *[other] Liší se { $count } hodnot.
    }

## How the timer writes its times: the question that no reading can answer.

byteOrder_title = Časy tohoto časovače klesají z řádku na řádek.
byteOrder_advice = Rostly by, kdyby se oba bajty každého času prohodily. Porovnejte s tím, co o časovači víte, a vyberte, než začnete zapisovat.
byteOrder_keep = Jsou správně, jak jsou zobrazeny
byteOrder_exchange = Prohodit je a číst znovu

## Why there is no connection.

connection_unsupported_title = { unsupportedHere_title }
connection_unsupported_advice = { unsupportedHere_advice }
connection_insecure_title = Prohlížeč zde sériové porty nedovoluje.
connection_insecure_advice = { restWorks }
connection_policy_title = Server této stránky sériové porty zakazuje.
connection_policy_advice = { restWorks }
connection_nothing-chosen_title = Nebyl vybrán žádný adaptér.
connection_nothing-chosen_advice = Stiskněte „Připojit“ a vyberte adaptér. Není-li v seznamu, pomohou kroky níže.
connection_not-allowed_title = { connection_insecure_title }
connection_not-allowed_advice = Povolte této stránce sériové porty v nastavení prohlížeče a znovu stiskněte „Připojit“.
connection_busy_title = Adaptér se neotevře.
connection_busy_advice = Nejčastěji ho má jiný program nebo karta. Zavřete je a znovu stiskněte „Připojit“.
connection_bad-settings_title = Adaptér toto nastavení nepřijímá.
connection_bad-settings_advice = { help_steps_usual-settings }
connection_unplugged_title = Adaptér není dostupný.
connection_unplugged_advice = Odpojte ho, znovu ho připojte a stiskněte „Připojit“. Co jste napsali, je uchováno.
connection_bad-reply_title = { link_heard_title }
connection_bad-reply_advice = { link_heard_advice }
connection_lost_title = { connection_unplugged_title }
connection_lost_advice = { connection_unplugged_advice }

## Why a job with the timer has ended.

timer_no-answer_title = Časovač neodpověděl.
timer_no-answer_advice = Krátce stiskněte tlačítko časovače, držte hlavici blíž než 20 cm a zkuste to znovu. Co jste napsali, je uchováno.
timer_bad-reply_title = Odpověď časovače nemůže být správná.
timer_bad-reply_advice = Zkuste to znovu. Pokud se to opakuje: Nastavení, Expert, Linka, „{ line_copyReport }“.
timer_unstable_title = Na lince je příliš šumu, nelze jí věřit.
timer_unstable_advice = Držte infračervenou hlavici blíž, mimo slunce, a zkuste to znovu.
timer_crowded_title = V paprsku může být víc než jeden časovač.
timer_crowded_advice = Dejte ostatní časovače a programátory dál a čtěte znovu.
timer_other-memory_title = Aktuální paměť není ta na obrazovce.
timer_other-memory_advice = Než budete zapisovat, čtěte znovu.
timer_memory-unknown_title = Tento časovač neříká, která paměť je aktuální.
timer_memory-unknown_advice = Stránka proto nemůže nahlédnout do jiné paměti a vrátit se. Aktuální můžete číst i zapisovat.
timer_memory-left_title = Pro příští let je teď možná vybrána jiná paměť.
timer_memory-left_advice = Stránka se nemohla vrátit na tu, která byla aktuální. Připojte se znovu a před letem vyberte pro příští let správnou paměť.
timer_other-timer_title = Toto není časovač, který odpovídal předtím.
timer_other-timer_advice = Stránka ho čte. Než budete zapisovat, podívejte se, co obsahuje.
timer_stale_title = Časovač neobsahuje to, co bylo zobrazeno.
timer_stale_advice = Nic nebylo zapsáno. Podívejte se, co by zápis změnil teď.
timer_changed_title = Časovač obsahuje jiné hodnoty než předtím.
timer_changed_advice = Změnilo je něco jiného, nebo je to jiný časovač. Vaše změny jsou uchovány: než budete zapisovat, podívejte se na rozdíl.
timer_stood-still_title = Stránka byla během práce s časovačem nějakou dobu pozastavena.
timer_stood-still_advice = Potom už nebylo nic posláno: může tam už být jiný časovač. Čtěte znovu.
timer_too-slow_title = Tento časovač odpovídá příliš pomalu.
timer_too-slow_advice = Na jeho odpovědi se čeká déle než 3 sekundy, takže stránka nepozná, která patří ke které otázce. Potom už nebylo nic posláno. Zkuste jiný adaptér, nebo kabel místo Bluetooth.
timer_undecided_title = { byteOrder_title }
timer_undecided_advice = { byteOrder_advice }
timer_serious_title = Kontrola našla něco závažného.
timer_serious_advice = { timer_stale_advice }
timer_busy_title = Něco na této stránce nebo v počítači používá adaptér.
timer_busy_advice = Nic nebylo posláno. Odpojte se a připojte znovu. Co jste napsali, je uchováno.
timer_port-lost_title = { link_lost_title }
timer_port-lost_advice = { link_lost_advice }
timer_aborted_title = Zastaveno.
timer_aborted_advice = Čtěte znovu a uvidíte, co časovač obsahuje.
timer_closed_title = Odpojeno.
timer_closed_advice = Chcete-li pokračovat, stiskněte „Připojit“. Co jste napsali, je uchováno.

## Replies that are no noise, which is random.

alike_title = Každá odpověď na { $request } je poškozená stejným způsobem.
alike_advice = To není šum: časovač nebo jeho adaptér tvoří tyto odpovědi neznámým způsobem. Zapněte v nastavení „Expert“, otevřete zobrazení „{ views_names_line }“ a stiskněte „{ line_copyReport }“. Zprávu pošlete správcům projektu (github.com/sidus-timer/sidus-timer/issues).
alike_part = Jen k nahlédnutí: { $values }. Vše ostatní není známo.

## Messages that are not about errors.

notes_back_title = Vaše změny jsou zpět.
notes_back_advice = Porovnejte je s tím, co časovač obsahuje, potom je zapište, nebo vezměte zpět.
notes_back-uncertain_title = { notes_back_title }
notes_back-uncertain_advice = Není známo, zda byly zapsány. Připojte časovač a před letem ho přečtěte.
notes_moved_title = { timer_changed_title }
notes_moved_advice = { timer_changed_advice }
notes_timer-moved_title = { timer_changed_title }
notes_timer-moved_advice = { timer_changed_advice }
notes_kept_title = Vaše změny jsou uchovány na tomto zařízení.
notes_kept_advice = K tomu, co bylo teď přečteno, se nehodí. Vrátí se, až příslušnou paměť znovu přečtete; jsou i v seznamu na úvodní stránce.
notes_other-kind_title = Teď je tu jiný druh časovače.
notes_other-kind_advice = { timer_other-timer_advice }
notes_write-completed_title = Přerušený zápis je úplný.
notes_write-completed_advice = Časovač byl znovu přečten a obsahuje vše, co mělo být zapsáno.
notes_nothing-written_title = { write_refused }
notes_nothing-written_advice = {""}
notes_not-backed-up_title = { write_unkept_title }
notes_not-backed-up_advice = { keeping_notKept }
notes_select-unanswered_title = Časovač neodpověděl, když se vybírala paměť.
notes_select-unanswered_advice = Na jiné požadavky odpovídá. Zkuste to znovu, nebo bez správného kontrolního součtu.
notes_backed-up_title = Všechny paměti byly přečteny a záloha každé z nich je uchována.
notes_backed-up_advice = {""}
notes_strays_title = { timer_crowded_title }
notes_strays_advice = { timer_crowded_advice }
notes_made-laid_title = Tabulka ukazuje váš program, ne to, co obsahuje časovač.
notes_made-laid_advice = Nic nebylo zapsáno. Co se liší, je označeno. „{ undo }“ ukáže, co obsahuje časovač.
notes_unexpected_title = Na této stránce se něco nepovedlo.
notes_unexpected_advice = Potom už nebylo nic posláno. Načtěte stránku znovu. Co jste napsali, je uchováno.

## The flight of the program, and what the servos of the model move.

preview_title = Náhled letu
preview_guessed = Není v měřítku.
preview_nameServos = Pojmenovat serva…
preview_play = Přehrát
preview_speed = Tempo
preview_time = Čas letu
preview_launch = Start
preview_at = { $what } ({ $time })
preview_sketch = Model z boku a jeho směrovka shora
preview_motor_true = Stoupání, motor běží
preview_motor_false = Kluz, motor stojí
preview_flies = V letu
preview_comesDown = DT: model klesá k zemi
preview_duties_rudder = Směrovka
preview_duties_tailplane = Výškovka
preview_duties_wing = Křídlo
preview_duties_release = Kotouč nebo šňůra DT
preview_duties_other = Něco jiného
preview_duties_none = Nepoužito
preview_naming_lead = Čím každé servo pohybuje a mezi kterými kroky. „Nahoru“ a „dolů“ platí pro odtokovou hranu.
preview_naming_duty = { $servo } pohybuje
preview_naming_name = Název toho, čím { $servo } pohybuje
preview_naming_low = { $servo }, jeden konec v krocích
preview_naming_high = { $servo }, druhý konec v krocích
preview_naming_from = od
preview_naming_to = do
preview_naming_sense = { $servo }, co dělá více kroků
preview_naming_otherSense_false = více kroků: nahoru
preview_naming_otherSense_true = více kroků: dolů
preview_naming_rudderSense_false = více kroků: doprava
preview_naming_rudderSense_true = více kroků: doleva

## The sheet of a program.

print_paper = Papír
print_what = Na listu
print_parts_lines = Linky k psaní
print_parts_code = QR kód
print_nothing = Vyberte programy z knihovny, nebo nějaký otevřete.
print_choose = Programy v tomto tisku: { $chosen }
print_clear = Odebrat vše
print_simulated = simulovaný časovač
print_warnings = Na toto se podívejte před letem
print_notes = Poznámky
print_codeHint = Fotoaparát telefonu otevře tento program, bez jeho poznámky.
print_unfinished =
    { $count ->
        [one] { $count } pole zatím nemá hodnotu: vytištěna je poslední
        [few] { $count } pole zatím nemají hodnotu: vytištěna je poslední
       *[other] { $count } polí zatím nemá hodnotu: vytištěna je poslední
    }
print_printed = Vytištěno { $date }

## The model in the strip.

recognition_which = Který model?
recognition_change = Model { $model }: určit, který model to je

## A memory with the pilot's name for it: M2 “fly-off”.

memoryNames_named = { $memory } „{ $name }“

## What an earlier job left behind on a timer.

recovery_title = Dřívější zápis byl přerušen.
recovery_when = Zápis začal { $time }. Paměť: { $memory }.
recovery_nothing =
    { $missing ->
        [one] Časovač obsahuje to, co předtím: nic nebylo zapsáno, chybí { $missing } změna.
        [few] Časovač obsahuje to, co předtím: nic nebylo zapsáno, chybí { $missing } změny.
       *[other] Časovač obsahuje to, co předtím: nic nebylo zapsáno, chybí { $missing } změn.
    }
recovery_part =
    { $missing ->
        [one] Z toho zápisu časovač obsahuje: { $values }; { $missing } hodnota je ještě jako předtím.
        [few] Z toho zápisu časovač obsahuje: { $values }; { $missing } hodnoty jsou ještě jako předtím.
       *[other] Z toho zápisu časovač obsahuje: { $values }; { $missing } hodnot je ještě jako předtím.
    }
recovery_foreign =
    { $count ->
        [one] { $count } hodnota v časovači není ani původní, ani z toho zápisu. Je to jiný časovač, nebo ji změnilo něco jiného?
        [few] { $count } hodnoty v časovači nejsou ani původní, ani z toho zápisu. Je to jiný časovač, nebo je změnilo něco jiného?
       *[other] { $count } hodnot v časovači není ani původních, ani z toho zápisu. Je to jiný časovač, nebo je změnilo něco jiného?
    }
recovery_sure = Stránka nerozezná časovače stejného druhu. Pokračujte, jen pokud je to časovač z toho zápisu.
recovery_finish = Dokončit zápis…
recovery_goBack = Zapsat původní hodnoty…
recovery_leave = Nechat, jak je
recovery_otherTimer = Je to jiný časovač
recovery_sameTimer = Je to tentýž časovač: ukázat, co se mělo zapsat
recovery_compare = Porovnat
recovery_before = Předtím
recovery_elsewhere = Zápis do časovače tohoto druhu byl přerušen. Paměť: { $memory }. Přečtěte ji a uvidíte, co obsahuje.
recovery_left = Práce stránky s paměťmi byla přerušena. Příští let: teď { $current }, předtím { $original }.
recovery_mayFly = Pro příští let je možná vybrána { $memory }: její výběr byl přerušen.
recovery_mayNotFly = Práce stránky s paměťmi byla přerušena. Pro příští let je možná vybrána jiná paměť než { $original }.
recovery_unknownMemory = neznámá paměť

## The backups.

backups_title = Zálohy
backups_empty = Před každým zápisem zde stránka uchová, co časovač obsahuje.
backups_reasons_write = před zápisem
backups_reasons_memories = všechny paměti

## How the page looks.

theme_title = Barvy
theme_names_system = Systém
theme_names_light = Světlé
theme_names_dark = Tmavé
theme_names_sun = Slunce

## The settings of the page.

settings_look = Vzhled
settings_expert = Expert: zobrazit linku
settings_expertHint = Linka ukazuje každý bajt mezi touto stránkou a časovačem. Zobrazení „{ views_names_bench }“ nabízí skok, který není popsán.
settings_kept = Co uchovává toto zařízení

## A saved program as a link and a QR code, and back.

share_offer_lead = Odkaz obsahuje celý program. Na server se nic neposílá.
share_offer_link = Odkaz
share_offer_copy = Kopírovat odkaz
share_offer_scan = Namiřte fotoaparát druhého zařízení na tento kód, nebo pošlete odkaz.
share_offer_qr = QR kód: „{ $name }“
share_offer_cut = Konec poznámky se do QR kódu nevejde. Odkaz obsahuje celou poznámku.
share_offer_tooLong = Na QR kód příliš dlouhé. Pošlete odkaz.
share_received_title = Program z odkazu
share_received_lead = Stránka ho zatím jen ukazuje. Nic se neuchovává a nic se nezapisuje do časovače.
share_received_known = Knihovna už tyto hodnoty má: { $name }.
share_received_modelChoice = Uchovat pod
share_received_newModel = Nový model „{ $name }“
share_received_keep = Uchovat v knihovně
share_received_discard = Neuchovávat
share_received_unwritten = Co jste napsali, je uchováno: „Zpět“, nebo úvodní stránka, to vrátí.
share_damaged_title = Tento odkaz nelze přečíst.
share_damaged_bad = Je useknutý nebo poškozený, nebo není z této stránky. Požádejte o něj znovu.
share_paste_title = Vložit odkaz…
share_paste_lead = Fotoaparát telefonu otevře QR kód sám. Zde můžete vložit odkaz.
share_paste_show = Zobrazit
share_paste_notLink = Toto není odkaz na program.

## A DT for trimming that is about to be flown. The page asks before the pilot disconnects, and at a contest round.

shortDt_held = { $memory }: DT je { $dt }.
shortDt_heldHere = DT je { $dt }.
shortDt_ask =
    { $remembered ->
        [true] Vrátit na { $back }?
       *[false] Nastavit na { $back }?
    }
shortDt_putBack =
    { $remembered ->
        [true] Vrátit DT na { $back }…
       *[false] Nastavit DT na { $back }…
    }
shortDt_disconnect = Odpojit takto: { $memory }, DT{"\u00a0"}{ $dt }
shortDt_disconnectHere = Odpojit takto: DT{"\u00a0"}{ $dt }
shortDt_blocked = Něco z toho, co jste napsali, zatím nelze zapsat. Opravte to, než vrátíte DT.
shortDt_settings_limit = DT je krátké pod
shortDt_settings_hint = Kratší DT je červené a stránka se zeptá, než se odpojíte. Při 0 s se neptá nikdy.

## The start, before anything was read.

start_title = Nastavte svůj časovač Sidus
start_lead = Přečtěte, co obsahuje, změňte to, zapište a nechte to ověřit. Nic neopustí toto zařízení.
start_adapter = Připojte adaptér
start_firefox = Firefox se nejprve zeptá na povolení a při každém načtení této stránky na port.
start_android = Telefon se připojí přes Bluetooth; kabel potřebuje Android { firstVersions_androidCable } a Chrome { firstVersions_android }.
start_readyOffline = Připraveno offline
start_install = Instalovat
start_picture_example = Příklad: F1Q
start_picture_kept = Uchováno { $time }
start_models_title = Moje modely
start_models_none = Uchovejte programy každého modelu, s poznámkami.
start_models_programs =
    { $count ->
        [one] { $count } program
        [few] { $count } programy
       *[other] { $count } programů
    }
start_models_library = Otevřít knihovnu
start_programs_title = Nedokončeno
start_programs_made = { $timer }, nový
start_programs_changesOf = { $timer }, změny
start_programs_sure = Smazat natrvalo?
start_simulatedTitle = Nemáte časovač u sebe?
start_simulatedLead = Simulovaný odpovídá jako skutečný, bajt po bajtu.
start_simulated = Vyzkoušet simulovaný časovač { $name }
start_backups =
    { $count ->
        [one] { $count } záloha, uchovaná před zápisem. Poslední: { $last }.
        [few] { $count } zálohy, uchované před zápisem. Poslední: { $last }.
       *[other] { $count } záloh, uchovaných před zápisem. Poslední: { $last }.
    }

## The dialog that makes a program without a timer.

newProgram_title = Nový program…
newProgram_timerClass = Třída
newProgram_functions = Funkce, bez startu a DT
newProgram_servos = Serva
newProgram_from = Na začátek
newProgram_beginnings_usual = Obvyklé časy, serva uprostřed
newProgram_beginnings_nothing = Všechny časy a polohy 0
newProgram_caution = Polohy vašeho modelu zde nejsou známy. Než budete zapisovat, nastavte každou z nich.
newProgram_make = Vytvořit program

## The picture of a program over time.

timeline_title = Časová osa
timeline_compareBefore = před sledováním
timeline_picture = Polohy serv v čase
timeline_description = { $servos } a { $functions } v čase, DT: { $dt }. Všechny hodnoty jsou v tabulce.
timeline_descriptionMotor = { $servos } a { $functions } v čase, DT: { $dt }, stop motoru: { $motorStop }. Všechny hodnoty jsou v tabulce.
timeline_functions =
    { $count ->
        [one] { $count } funkce
        [few] { $count } funkce
       *[other] { $count } funkcí
    }
timeline_servos =
    { $count ->
        [one] { $count } servo
        [few] { $count } serva
       *[other] { $count } serv
    }
timeline_keysToEdit = Šipky vedou od značky ke značce a od serva k servu, plus a minus mění zvětšení, 0 ukáže vše. Enter vede k úchytům: šipky jimi pohybují, Escape se vrátí.
timeline_ask = Ukažte nebo klepněte a čtěte
timeline_finer = Jemněji
timeline_steps =
    { $position ->
        [one] { $position } krok
        [few] { $position } kroky
       *[other] { $position } kroků
    }
timeline_stepsUnit = kroků
timeline_notKnown = Není známo: časy klesají
timeline_tools = Zobrazení
timeline_zoomIn = Přiblížit
timeline_zoomOut = Oddálit
timeline_fit = Zobrazit vše
timeline_passedOver = Přeskočeno: { $slot }, protože { $next } přijde ve stejný čas.
timeline_goesBack = { $next } přijde dřív než { $slot }. Není známo, co časovač dělá ve vystínované části.

## A new version of the page.

update_ready = Je připravena nová verze.
update_waits = Spustí se, až se odpojíte a nic nebude otevřené ani neuložené.
update_take = Použít teď
update_news = Co je nového

## The version of this page.

aboutPage_title = Tato stránka
aboutPage_version = Sidus Timer { $version }.
aboutPage_offline = Celá stránka je na tomto zařízení: funguje bez sítě.
aboutPage_notOffline = Stránka ještě není uchována na tomto zařízení: otevřete ji jednou se sítí.
aboutPage_licences = Licence

## The views of the page and the links between them.

views_title = Zobrazení
views_names_program = Program
views_names_memories = Paměti
views_names_bench = Zkoušky
views_names_library = Knihovna
views_names_line = Linka
views_names_settings = Nastavení
views_names_print = Tisk
views_names_help = Nápověda
views_print = Tisk…
views_share = Sdílet…
views_noTimer_memories = Připojte časovač a uvidíte jeho paměti. Zálohy jsou níže.
views_noTimer_bench = Připojte časovač, abyste mohli pohybovat jeho servy.

## The strip above every view: the timer, its memory, DT, motor stop, and what is known.

strip_panel = Paměti a další
strip_tried = zkoušeno: { $count }
strip_notCertain = nejisté
strip_asRead = posl. čtení
strip_notValid = neplatné
strip_ofSetting =
    { $changes ->
        [0] uloženo
       *[other] neuloženo: { $changes }
    }
strip_made = ne v časovači

## The list of commands.

palette_title = Příkazy
palette_search = Napište, co chcete udělat
palette_nothing = Žádný příkaz se tak nejmenuje, nebo ho teď nelze provést.
palette_ctrl = Ctrl+{ $key }

## In place of a part of the page that is being loaded.

parts_coming = Načítá se
parts_failed = Část této stránky se nepodařilo načíst.
parts_again = Zkusit znovu

## Which model it is.

whichModel_recognition_same = Toto je { $model }, obsah jako při čtení { $when }.
whichModel_recognition_like =
    { $count ->
        [one] Podobá se modelu { $model }, liší se { $count } hodnota. Je to { $model }?
        [few] Podobá se modelu { $model }, liší se { $count } hodnoty. Je to { $model }?
       *[other] Podobá se modelu { $model }, liší se { $count } hodnot. Je to { $model }?
    }
whichModel_recognition_several = Může to být { $models }. Který model to je?
whichModel_or = { $names } nebo { $last }
whichModel_others = jeden z { $count } dalších
whichModel_recognition_unknown = Tento časovač zde není znám. Který model to je?
whichModel_recognition_yes = Ano, { $model }
whichModel_recognition_choose = Vybrat…
whichModel_recognition_ok = OK
whichModel_recognition_dialog_title = Který model to je?
whichModel_recognition_dialog_lead = Časovač svůj model nezná. Stránka porovnává jeho obsah s tím, co v každém modelu viděla naposledy.
whichModel_recognition_dialog_said = Řekli jste, že je to { $model }.
whichModel_recognition_dialog_moreMemories = Přečtěte i ostatní paměti: mohou pomoci modely rozlišit.
whichModel_recognition_dialog_none = Takový model této třídy není.
whichModel_recognition_dialog_newModel = Nový model
whichModel_recognition_dialog_keep = Uchovat jako nový model
whichModel_memoryNames_label = Název paměti { $memory }
whichModel_memoryNames_give = Pojmenovat
whichModel_crossing_title = Jsou to hodnoty modelu { $from }, ale tento časovač vypadá jako časovač modelu { $to }.
whichModel_crossing_advice = S hodnotami jiného modelu můžete tento ztratit. Podívejte se na model před sebou.
whichModel_crossing_confirm = Zapsat hodnoty modelu { $from } do časovače modelu { $to }.
whichModel_crossing_memoryOf = { $memory } ({ $model })

## A write, from the difference to the verdict.

write_title = Zapsat do časovače
write_lead = Toto se změní. Paměť: { $memory }. Vše ostatní zůstane, jak je.
write_target = Zapsat do
write_nothing = Nic se neliší. Časovač se kontrolně přečte a porovná.
write_field = Hodnota
write_from = V časovači
write_to = Bude
write_wasRead = Předchozí čtení
write_moved_model_title = Zdá se, že tento časovač teď patří jinému modelu.
write_moved_model_advice = Nic nebylo zapsáno. Podívejte se na názvy modelů.
write_moved_edits_title = Program se změnil od chvíle, kdy to bylo zobrazeno.
write_unkept_title = Na tomto zařízení se nepodařilo uchovat zálohu toho, co časovač obsahuje teď.
write_unkept_advice = Tato paměť je stále jako předtím. Pokračovat bez zálohy?
write_sideBySide = Hodnoty: { $names }
write_withoutCopy = Pokračovat bez zálohy
write_safety = Vrtule je sundaná nebo model někdo drží; časovač přitom není odjištěný.
write_acknowledge = Mám to přečtené, přesto chci zapsat.
write_stillToTick = Zbývá zaškrtnout: { $ticks }.
write_ticks_model = jiný model
write_ticks_warnings = upozornění
write_ticks_safety = vrtule
write_move_why = Zdá se, že tento časovač zachová polohy jen tam, kde stojí jeho serva. Když se serva nepohnou, tyto polohy pravděpodobně nezachová.
write_move_label = Přestavit serva na každou funkci, než si časovač zapamatuje její polohy.
write_move_hint = Držte model bezpečně, servům nesmí nic překážet.
write_move_notHeld_title = Časovač polohy potvrdil, ale nezachoval je.
write_move_notHeld_advice = Tento časovač je pravděpodobně zachová jen tam, kde stojí jeho serva. Zapište znovu a nechte serva přestavit na každou funkci.
write_move_again = Zapsat znovu…
write_start =
    { $count ->
        [0] Kontrolně přečíst a porovnat
        [one] Zapsat { $count } změnu
        [few] Zapsat { $count } změny
       *[other] Zapsat { $count } změn
    }
write_stages_read = Čtení
write_stages_write = Zápis
write_stages_verify = Kontrolní čtení
write_stages_repair = Oprava
write_stopping = Zastaví se po tomto požadavku
write_stoppingBack = Zastavuje se: nejprve zpět na předchozí paměť
write_verified_title = Ověřeno.
write_verified_advice = Časovač byl kontrolně přečten a obsahuje, co bylo zobrazeno.
write_verdict = { $memory }: ověřeno { $time }
write_asItIs = beze změny
write_insteadOf = místo { $value }
write_wanted = K zápisu
write_readBack = Kontrolní čtení
write_differs_title = Časovač nepřijal všechny hodnoty.
write_differs_advice = Časovač byl kontrolně přečten. Zde obsahuje jiné hodnoty:
write_unknown_title = Není jisté, co časovač obsahuje.
write_unknown_advice = Časovač se nepodařilo kontrolně přečíst celý. Čtěte znovu, potom zapište, co se ještě liší. Vaše změny jsou uchovány.
write_cut = Zápis byl přerušen. Paměť: { $memory }.
write_strayed_title = Během zápisu se aktuální stala { $memory }.
write_strayed_advice = Některé hodnoty teď mohou být v paměti { $memory }. Přečtěte ji a celou ji prohlédněte, než s ní poletíte.
write_refused = Nic nebylo zapsáno.
write_status_differs = jiná
write_status_unknown = není známo
write_putBack = sama se změnila, vrácena

## What the parts of the page that are loaded first say.

name = Sidus Timer
classNames_Q = F1Q
classNames_B = F1B
classNames_E = F1E
unknownClass = Třída { $letter }
memoryName = M{ $number }
servoName = S{ $number }
slotName =
    { $kind ->
        [start] Start
        [dt] DT
       *[function] Funkce { $slot }
    }
within_slot =
    { $kind ->
        [start] start
        [dt] DT
       *[function] funkce { $slot }
    }
within_idleThrottle = volnoběh
slotShort =
    { $kind ->
        [start] Start
        [dt] DT
       *[function] { $slot }
    }
about = { $name }:
previous = Předchozí
next = Další
pause = Pauza
less = { $what }: méně
moreOf = { $what }: více
seconds = { $time }{" "}s
times_minutes = { $minutes }{" "}min
times_minutesSeconds = { $minutes }{" "}min { $seconds }{" "}s
times_units_s = s
times_units_min = min
times_figure = { $text } { $unit }
times_asSeconds = { $seconds }{" "}s, { $clock }
times_meaning = { $field }: co znamená napsaný text
header_firmware = firmware { $firmware }
header_simulated = simulovaný
header_connect = Připojit
header_choosePort = Vybrat jiný adaptér
header_closeProgram = Zavřít program
header_disconnect = Odpojit
header_stop = Zastavit
program_tableCaption = Čas a polohy serv každé funkce
program_slot = Funkce
program_time = Čas
program_memory = Paměť
program_memoryUnknown = Tento časovač neříká, která paměť je aktuální, takže není známo, která je vybrána pro příští let.
program_memoryOpen = Není známo, která paměť je vybrána pro příští let. Vyberte některou pro příští let, nebo čtěte znovu.
program_dt = DT
program_motorStop = Stop motoru
program_motor = Motor
program_idleThrottle = Volnoběh
program_throttle = Volnoběh
program_idleThrottleUnit = jednotka neznámá
program_reserved = vyhrazeno { $time }
program_timeOf = { $slot }, čas
program_motorStopTime = Stop motoru, čas
program_positionOf = { $slot }, { $servo }
program_shortDt = Krátké DT
program_changes =
    { $count ->
        [one] { $count } změna
        [few] { $count } změny
       *[other] { $count } změn
    }
program_undoAll = Vše zpět
program_read = Číst znovu
program_connectAndWrite = Připojit a zapsat…
program_write =
    { $count ->
        [0] Zapsat…
        [one] Zapsat { $count } změnu…
        [few] Zapsat { $count } změny…
       *[other] Zapsat { $count } změn…
    }
program_picture = Obraz
program_table = Tabulka
program_blocked = Zatím nelze nic zapsat. { $field }: { $why }
program_findings = Kontrola
program_noFindings = Nic neobvyklého.
program_absolute = Časy jsou uvedeny od startu. Není známo, zda tento časovač počítá od startu, nebo od předchozí funkce.
program_severity_error = Nelze zapsat
program_severity_serious = Závažné
program_severity_warning = Neobvyklé
program_reading = Čtení časovače
program_selecting = Změna paměti
otherTab_holdsSince = Sidus Timer je otevřen v jiné kartě, od { $since }.
otherTab_holds = Sidus Timer je otevřen v jiné kartě.
otherTab_takeOver = Použít zde
otherTab_busy = Druhá karta pracuje s časovačem. Jakmile skončí, stránka se otevře zde.
otherTab_gone = Druhá karta neodpovídá. Zavřete ji a načtěte tuto stránku znovu.
disturbed = Odpovědi chybí nebo jsou poškozené: je časovač vzhůru a infračervená hlavice blízko, mimo slunce? Skončí to nejpozději za { $seconds } s.
cancel = Zrušit
close = Zavřít
copy = Kopírovat
copied = Zkopírováno.
copyByHand = Prohlížeč této stránce nedovolí kopírovat. Zkopírujte to odsud.
dismiss = Skrýt
done = Hotovo
undo = Zpět
open = Otevřít
save = Uložit
delete = Smazat
notNow = Teď ne
label_language = Jazyk
label_name = Název
label_note = Poznámka
label_model = Model
label_search = Hledat
noModel = Bez modelu
more = A ještě { $count }.
showMore = Zobrazit ještě { $count }
of = { $button }: { $name }
notFitting = Nehodí se k připojenému časovači. Chcete-li ho otevřít, odpojte se.
notKept = Tento prohlížeč to neuchoval: při zavření stránky se to ztratí.

## The walk through the open questions of docs/protocol.md with a real timer.

settle_title = Vyjasněte to svým časovačem
settle_lead = O tom, jak tyto časovače mluví, není známo vše. Za patnáct minut ten váš vyjasní, co je otevřené. Po každé zkoušce se vrátí původní hodnota. Mějte po ruce ruční programátor.
settle_safe = Vrtule je sundaná nebo motor odpojený; časovač přitom není odjištěný.
settle_danger = Teď se může něco pohnout. Je vrtule sundaná nebo motor odpojený? Podívejte se ještě jednou.
settle_blocked = Nejprve vyřešte, co říká barevný pruh nahoře, a ponechte, co bylo vyzkoušeno, nebo vraťte, co bylo předtím.
settle_readIt = Přečíst časovač
settle_which = Co ukazuje programátor?
settle_tryHint = Přestavte serva tlačítky stránky a počkejte, až se zastaví. Potom zkuste polohu: změní se a do několika sekund se vrátí. Dívejte se na serva.
settle_tryIt = Zkusit polohu
settle_moved = Původní poloha je zpět v časovači: stránka ji přečetla. Pohnulo se při zkoušení nové některé servo?
settle_ask = Zeptat se se čtyřmi nulami
settle_unknown = Nevím
settle_send = Poslat soubor tímto formulářem
settle_names_order = Nižší bajt času je první
settle_names_unit = Časy jsou v setinách sekundy
settle_names_count = Časy se počítají od startu
settle_names_memories = První paměť má číslo 0
settle_names_zeros = Čtyři nuly stačí
settle_names_layout = Funkce je před servem
settle_names_stores = Polohy se zachovají u kterékoli funkce
settle_names_moves = Zapsaná poloha pohne svým servem
settle_names_unlock = Písmeno odpovědi na UNLOCK
settle_names_delay = Obvyklá doba odpovědi
settle_names_reserved = Vyhrazený čas, jak byl přečten
settle_yes = Ano
settle_no = Ne
settle_unnumbered = Číslo není udáno
settle_there = Jen tam, kde serva stojí
settle_delay = { $ms } ms
settle_open = Nevyjasněno
